#!/usr/bin/env python3
"""Measures the cost of a call in a loop: 100 runs of one Flow and 100 starts of `wend run`, each moving a handle of a
mesh of 5,000 vertices by 1 % of its size, with one thread. Prints the median of the time and the mean of the processor
time of both in milliseconds: the numbers of docs/library.md.

usage: PYTHONPATH=build/release scripts/library_cost.py [path of wend]; needs python3-numpy.
"""
import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import wend

CALLS = 100


def timed(call):
    start = time.perf_counter()
    call()
    return 1000 * (time.perf_counter() - start)


def processor_time(whose):
    used = resource.getrusage(whose)
    return 1000 * (used.ru_utime + used.ru_stime) / CALLS


def main(program):
    points, cells = wend.mesh_polygons([[(0, 0), (4, 0), (4, 1), (0, 1)]], vertices=5000)
    step = 0.01 * 17 ** 0.5
    ways = [step * np.array([np.cos(a), np.sin(a)]) for a in np.linspace(0, 6, CALLS)]
    flow = wend.Flow(points, cells, threads=1)
    flow.hold(wend.half_space((0, 0), (-1, 0)))
    end = flow.move(wend.half_space((4, 0), (1, 0)), None)

    def run(way):
        flow.reset()
        flow.set_movement(end, wend.translate(way))
        assert flow.run()
        return flow.points
    run(ways[0])
    before = processor_time(resource.RUSAGE_SELF)
    loop = [timed(lambda: run(way)) for way in ways]
    in_loop = processor_time(resource.RUSAGE_SELF) - before
    with tempfile.TemporaryDirectory() as folder:
        mesh, project, out = (pathlib.Path(folder) / name for name in ('a.vtu', 'a.wend', 'b.vtu'))
        wend.write_mesh(mesh, points, cells)
        starts = []
        for way in ways:
            project.write_text(json.dumps({
                'format': 'wend', 'version': 1, 'domain': {'mesh': 'a.vtu'}, 'handles': [
                    {'at': {'region': {'halfspace': {'point': [0, 0], 'normal': [-1, 0]}}}},
                    {'at': {'region': {'halfspace': {'point': [4, 0], 'normal': [1, 0]}}},
                     'motion': [{'kind': 'translate', 'by': list(way), 'time': [0, 1]}]}]}))
            starts.append(timed(lambda: subprocess.run([program, 'run', project, '--mesh', out, '--quiet', '--threads', '1'], check=True)))
            again = run(way)
            assert again.tobytes() == wend.read_mesh(out)[0].tobytes()
    in_starts = processor_time(resource.RUSAGE_CHILDREN)
    print(f'{len(points)} vertices: {statistics.median(loop):.1f} ms (processors {in_loop:.1f}) a call of Flow.run, '
          f'{statistics.median(starts):.1f} ms (processors {in_starts:.1f}) a start of wend run')


if __name__ == '__main__':
    main(sys.argv[1] if len(sys.argv) > 1 else 'build/release/wend')
