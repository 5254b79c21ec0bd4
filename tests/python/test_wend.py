"""Tests the Python module against closed forms and against `wend run`.

usage: test_wend.py WEND, with the folder of the module in PYTHONPATH.
"""
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
import warnings

import numpy as np

import wend

WEND = sys.argv.pop(1) if len(sys.argv) > 1 else 'wend'


def grid(nx, ny, width, height):
    x, y = np.meshgrid(np.linspace(0, width, nx + 1), np.linspace(0, height, ny + 1))
    points = np.stack([x.ravel(), y.ravel()], 1)
    a = (np.arange(ny)[:, None] * (nx + 1) + np.arange(nx)).ravel()
    b = a + nx + 1
    cells = np.concatenate([np.stack([a, a + 1, b + 1], 1), np.stack([a, b + 1, b], 1)])
    return points, cells


def rotated(points, centre, angle):
    c, s = math.cos(angle), math.sin(angle)
    return (points - centre) @ np.array([[c, s], [-s, c]]) + centre


def bent_strip(**options):
    flow = wend.Flow(*grid(24, 6, 4, 1), **options)
    flow.hold(wend.half_space((0, 0), (-1, 0)))
    flow.move(wend.half_space((4, 0), (1, 0)), wend.rotate((2, 0.5), 1.2))
    return flow


STRIP = {
    'format': 'wend', 'version': 1, 'domain': {'mesh': 'strip.obj'}, 'material': {'phi': 'metr'},
    'handles': [{'at': {'region': {'halfspace': {'point': [0, 0], 'normal': [-1, 0]}}}},
                {'at': {'region': {'halfspace': {'point': [4, 0], 'normal': [1, 0]}}},
                 'motion': [{'kind': 'rotate', 'centre': [2, 0.5], 'angle': 1.2, 'time': [0, 1]}]}],
}


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def strip(self):
        wend.write_mesh(str(self.folder / 'strip.obj'), *grid(24, 6, 4, 1))
        return STRIP

    def program(self, *arguments):
        done = subprocess.run([WEND, *map(str, arguments)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout


class FlowTest(unittest.TestCase):
    def test_rigid_motion(self):
        points, cells = grid(8, 8, 1, 1)
        flow = wend.Flow(points, cells, tolerance=1e-9, phi='akvf')
        flow.move([0, 8, 80], wend.rotate((0.25, 0.5), 2))
        self.assertTrue(flow.run())
        self.assertLess(np.abs(flow.points - rotated(points, (0.25, 0.5), 2)).max(), 1e-6)
        self.assertLess(flow.distortion().total_metric, 1e-12)
        self.assertTrue((flow.rest_points == points).all())
        self.assertTrue((flow.cells == cells).all())

    def test_stretch(self):
        points, cells = grid(6, 6, 1, 1)
        flow = wend.Flow(points, cells, phi='akvf', tolerance=1e-8)
        flow.hold(wend.half_space((0, 0), (-1, 0)).free([False, True]))
        flow.move(wend.half_space((1, 0), (1, 0)).free([False, True]), wend.translate((1, 0)))
        flow.hold([0])
        result = flow.run()
        self.assertEqual((result.ending, result.message, bool(result)), ('done', '', True))
        self.assertLess(np.abs(flow.points - points * (2, 1)).max(), 1e-6)
        # For the stretches σ = (2, 1), the errors of angles and of areas are both (2 − 1)² / 2.
        distortion = flow.distortion()
        self.assertEqual(distortion.angle.shape, (len(cells),))
        np.testing.assert_allclose(distortion.angle, 0.5, atol=1e-5)
        np.testing.assert_allclose(distortion.volume, 0.5, atol=1e-5)
        np.testing.assert_allclose(distortion.ratio, 2, atol=1e-5)
        self.assertAlmostEqual(flow.min_det(), 2, 5)

    def test_space(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], float)
        cells = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
        flow = wend.Flow(points, cells, phi=wend.phi_of('conf', 3), tolerance=1e-9)
        flow.move([0, 1, 2], wend.rotate((0, 0, 0), math.pi / 2, (0, 0, 1)))
        self.assertTrue(flow.run())
        self.assertEqual(flow.points.shape, (5, 3))
        turned = points @ np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
        self.assertLess(np.abs(flow.points - turned).max(), 1e-6)

    def test_loop_equals_fresh_flows(self):
        flow = bent_strip()
        for angle in (0.3, -0.4, 1.0):
            flow.reset()
            flow.set_movement(1, wend.rotate((2, 0.5), angle))
            self.assertTrue(flow.run())
            fresh = wend.Flow(*grid(24, 6, 4, 1))
            fresh.hold(wend.half_space((0, 0), (-1, 0)))
            fresh.move(wend.half_space((4, 0), (1, 0)), wend.rotate((2, 0.5), angle))
            fresh.run()
            self.assertEqual(flow.points.tobytes(), fresh.points.tobytes())

    def test_pieces_in_order(self):
        points, cells = grid(8, 8, 1, 1)
        flow = wend.Flow(points, cells)
        flow.move([0, 8, 80], [wend.translate((1, 0), time=(0, 0.5), ease='in-out'),
                               wend.follow([(0, 0), (0, 1)], 'polyline', time=(0.5, 1)),
                               wend.displace([0, 8, 80], np.full((3, 2), 0.5), time=(1, 2))])
        self.assertTrue(flow.run())
        self.assertEqual(flow.time, 2)
        self.assertLess(np.abs(flow.points - points - 1.5).max(), 1e-6)
        flow.reset()
        flow.run(0.5)
        self.assertLess(np.abs(flow.points - points - (1, 0)).max(), 1e-6)
        np.testing.assert_allclose(flow.velocity(), np.tile([0, 2], (81, 1)), atol=1e-9)

    def test_material_per_cell(self):
        points, cells = grid(6, 4, 3, 2)
        phi = np.full(len(cells), wend.phi_of('metr', 2))
        B = np.tile(np.eye(2), (len(cells), 1, 1))
        results = []
        for options in ({}, {'phi': phi}, {'phi': phi, 'anisotropy': B}, {'phi': float(phi[0])}):
            flow = wend.Flow(points, cells, tolerance=1e-8, **options)
            flow.hold(wend.box((-1, -1), (0.1, 3)))
            flow.move(wend.ball((3, 1), 0.6), wend.translate((0.3, 0.4)))
            self.assertTrue(flow.run())
            results.append(flow.points)
        for result in results[1:]:
            np.testing.assert_allclose(result, results[0], atol=1e-6)
        stiff = B.copy()
        stiff[:, 0, 0] = 50
        flow = wend.Flow(points, cells, anisotropy=stiff)
        flow.hold(wend.box((-1, -1), (0.1, 3)))
        flow.move(wend.ball((3, 1), 0.6), wend.translate((0.3, 0.4)))
        flow.run()
        self.assertGreater(np.abs(flow.points - results[0]).max(), 1e-3)

    def test_elastic_loop_closes(self):
        points, cells = grid(12, 4, 3, 1)
        there = [wend.translate((-0.4, 0.8)), wend.translate((0.4, 0), time=(1, 2)),
                 wend.translate((0, -0.8), time=(2, 3))]
        for memory in ('elastic', math.inf):
            flow = wend.Flow(points, cells, memory=memory)
            flow.hold(wend.half_space((0, 0), (-1, 0)))
            flow.move([12, 38, 64], there)
            self.assertTrue(flow.run(1))
            self.assertGreater(np.abs(flow.points - points).max(), 0.5)
            self.assertTrue(flow.run())
            self.assertLess(np.abs(flow.points - points).max(), 1e-6)
            self.assertEqual(flow.statistics()['snaps'], [])

    def test_fold_is_a_value(self):
        flow = wend.Flow(*grid(4, 4, 1, 1))
        flow.hold(wend.half_space((0, 0), (-1, 0)))
        flow.move(wend.half_space((1, 0), (1, 0)), wend.translate((-1.5, 0)))
        result = flow.run()
        self.assertFalse(result)
        self.assertNotEqual(result.message, '')
        self.assertLess(result.time, 2 / 3)
        self.assertGreater(flow.min_det(), 0)

    def test_errors(self):
        points, cells = grid(2, 2, 1, 1)
        for bad, words in ((lambda: wend.Flow(points[:, 0], cells), 'shape'),
                           (lambda: wend.Flow(points, cells[:, :2]), 'shape'),
                           (lambda: wend.Flow(points, cells, phi='soft'), 'equia, metr, akvf, conf'),
                           (lambda: wend.Flow(points, cells, phi=7.0), 'phi = 7'),
                           (lambda: wend.Flow(points, cells + 5), 'vert'),
                           (lambda: wend.Flow(points, cells).hold('left'), 'place'),
                           (lambda: wend.Flow(points, cells).hold([0.5]), 'place'),
                           (lambda: wend.Flow(points, cells).hold(wend.ball((0, 0, 0), 1)), 'dimension'),
                           (lambda: wend.Flow(points, cells).move([0], wend.translate((0, 0, 1))), 'dimension'),
                           (lambda: wend.translate((0, 0), ease='fast'), 'linear'),
                           (lambda: wend.read_mesh('/nowhere/mesh.obj'), '/nowhere/mesh.obj'),
                           (lambda: wend.run('/nowhere/a.wend'), '/nowhere/a.wend')):
            with self.assertRaises(wend.InvalidInput) as caught:
                bad()
            self.assertIn(words, str(caught.exception))
            self.assertIsInstance(caught.exception, ValueError)
        flow = wend.Flow(points, cells)
        flow.hold([77])
        with self.assertRaisesRegex(wend.InvalidInput, '77'):
            flow.run()


class ThreadTest(unittest.TestCase):
    def test_progress(self):
        times = []
        flow = bent_strip(tolerance=1e-7)
        flow.run(progress=times.append)
        self.assertEqual(times, sorted(times))
        self.assertTrue(all(0 < t <= 1 for t in times))

    def test_progress_may_raise(self):
        flow = bent_strip(tolerance=1e-9)

        def stop(time):
            raise LookupError('enough')
        with self.assertRaisesRegex(LookupError, 'enough'):
            flow.run(progress=stop)
        self.assertGreater(flow.min_det(), 0)
        self.assertTrue(flow.run())

    def test_interpreter_is_free(self):
        """Checks that another thread runs while a flow does, and that the flow refuses its access."""
        flow, refused, running = bent_strip(method='rk4', steps=2000), [], threading.Event()

        def look():
            running.wait()
            try:
                flow.points
            except wend.InvalidInput as error:
                refused.append(str(error))
            flow_is_seen.set()
        flow_is_seen = threading.Event()
        other = threading.Thread(target=look)
        other.start()

        def wait(time):  # called within the run, so that the other thread accesses the flow meanwhile
            running.set()
            flow_is_seen.wait()
        self.assertTrue(flow.run(progress=wait))
        other.join()
        self.assertEqual(len(refused), 1)
        self.assertIn('running', refused[0])

    def test_two_flows_in_two_threads(self):
        alone = bent_strip()
        alone.run()
        flows = [bent_strip(), bent_strip()]
        threads = [threading.Thread(target=flow.run) for flow in flows]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for flow in flows:
            self.assertEqual(flow.points.tobytes(), alone.points.tobytes())

    def test_interrupt(self):
        """Checks that a signal interrupts a run that would otherwise take hours."""
        flow, started = bent_strip(method='rk4', steps=20000000), threading.Event()

        def interrupt():
            started.wait()
            os.kill(os.getpid(), signal.SIGINT)
        other = threading.Thread(target=interrupt)
        other.start()
        with self.assertRaises(KeyboardInterrupt):
            flow.run(progress=lambda time: started.set())
        other.join()
        self.assertGreater(flow.min_det(), 0)
        self.assertLess(flow.time, 1)


class ProjectTest(InFolder):
    def test_equals_the_program(self):
        project = self.strip()
        (self.folder / 'strip.wend').write_text(json.dumps(project))
        self.program('run', self.folder / 'strip.wend', '--mesh', self.folder / 'program.obj', '--report',
                     self.folder / 'report.json')
        report = wend.run(project, folder=str(self.folder), mesh=str(self.folder / 'module.obj'))
        self.assertEqual((self.folder / 'program.obj').read_bytes(), (self.folder / 'module.obj').read_bytes())
        expected = json.loads((self.folder / 'report.json').read_text())
        for key in ('errors', 'minDet', 'steps', 'evaluations', 'energy', 'restEnergy', 'constraintError', 'reached'):
            self.assertEqual(report[key], expected[key], key)
        flow = wend.load(project, folder=str(self.folder))
        self.assertTrue(flow.run())
        points, cells = wend.read_mesh(str(self.folder / 'program.obj'))
        self.assertEqual(flow.points.tobytes(), points.tobytes())
        self.assertTrue((flow.cells == cells).all())
        self.assertEqual(flow.min_det(), expected['minDet'])
        strip = bent_strip()
        strip.run()
        self.assertEqual(strip.points.tobytes(), points.tobytes())

    def test_options_are_those_of_the_program(self):
        project = self.strip()
        (self.folder / 'strip.wend').write_text(json.dumps(project))
        self.program('run', self.folder / 'strip.wend', '--mesh', self.folder / 'program.ply', '--at', 0.5,
                     '--tolerance', 1e-6, '--settle', '--phi', 'conf', '--encoding', 'binary')
        wend.run(self.folder / 'strip.wend', mesh=[str(self.folder / 'a.ply'), str(self.folder / 'b.ply')], at=0.5,
                 tolerance=1e-6, settle=True, phi='conf', encoding='binary', partial=False)
        for name in ('a.ply', 'b.ply'):
            self.assertEqual((self.folder / 'program.ply').read_bytes(), (self.folder / name).read_bytes())
        with self.assertRaisesRegex(wend.InvalidInput, '--speed'):
            wend.run(project, folder=str(self.folder), speed=3)
        with self.assertRaisesRegex(wend.InvalidInput, '--tolerance'):
            wend.run(project, folder=str(self.folder), tolerance=3)

    def test_dict_in_dict_out(self):
        project = self.strip()
        wend.write_project(str(self.folder / 'a.wend'), project, folder=str(self.folder))
        read = wend.read_project(self.folder / 'a.wend')
        self.assertEqual(read['domain'], project['domain'])
        self.assertEqual(read['handles'][1]['motion'][0]['angle'], 1.2)
        wend.write_project(str(self.folder / 'b.wend'), read, folder=str(self.folder))
        self.assertEqual((self.folder / 'a.wend').read_bytes(), (self.folder / 'b.wend').read_bytes())
        self.program('run', self.folder / 'b.wend', '--report', '-')
        with self.assertRaisesRegex(wend.InvalidInput, 'version'):
            wend.write_project(str(self.folder / 'c.wend'), {'format': 'wend', 'version': 99})
        self.assertFalse((self.folder / 'c.wend').exists())
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter('always')
            wend.load(dict(project, colour='red'), folder=str(self.folder))
        self.assertIn('colour', str(caught[0].message))

    def test_incomplete(self):
        project = json.loads(json.dumps(self.strip()))
        project['handles'][1]['motion'] = [{'kind': 'translate', 'by': [-6, 0], 'time': [0, 1]}]
        with self.assertRaises(wend.Incomplete):
            wend.run(project, folder=str(self.folder))

    def test_picture_equals_the_program(self):
        image = np.zeros((60, 80, 3), np.uint8)
        image[::4] = 255
        image[:, ::8, 1] = 128
        wend.write_picture(str(self.folder / 'a.png'), image)
        project = {'format': 'wend', 'version': 1,
                   'domain': {'image': 'a.png', 'outline': {'from': 'frame'}, 'vertices': 300},
                   'handles': [{'at': {'points': [[2, 2], [2, 58]]}},
                               {'at': {'points': [[70, 30]]},
                                'motion': [{'kind': 'translate', 'by': [5, 8], 'time': [0, 1]}]}]}
        (self.folder / 'a.wend').write_text(json.dumps(project))
        self.program('run', self.folder / 'a.wend', '--image', self.folder / 'program.png')
        flow = wend.load(project, folder=str(self.folder))
        flow.run()
        warped = wend.warp(image, flow.rest_points, flow.cells, flow.points)
        np.testing.assert_array_equal(warped, wend.read_picture(str(self.folder / 'program.png')))


class PictureTest(InFolder):
    def test_whole_pixels(self):
        for type in (np.uint8, np.uint16, np.float16, np.float32):
            image = (np.arange(20 * 40 * 4) % 251).reshape(20, 40, 4).astype(type)
            image[..., 3] = 255 if type == np.uint8 else 65535 if type == np.uint16 else 1
            points, cells = wend.mesh_picture(image, vertices=100)
            moved = wend.warp(image, points, cells, points + (10, 3), filter='nearest')
            self.assertEqual(moved.dtype, image.dtype)
            np.testing.assert_array_equal(moved[3:, 10:], image[:-3, :-10])
            self.assertFalse(moved[:3].any() or moved[:, :10].any())
            part = wend.warp(image, points, cells, points + (10, 3), filter='nearest', part=(10, 3, 40, 20))
            np.testing.assert_array_equal(part, image)

    def test_gray_gets_alpha(self):
        image = np.full((10, 12), 100, np.uint8)
        points, cells = wend.mesh_picture(image, vertices=50)
        self.assertEqual(wend.warp(image, points, cells, points).shape, (10, 12))
        moved = wend.warp(image, points, cells, points + (6, 0))
        self.assertEqual(moved.shape, (10, 12, 2))
        self.assertEqual(moved[:, :, 1].tolist(), [[0] * 6 + [255] * 6] * 10)

    def test_outline_of_alpha(self):
        image = np.zeros((100, 100, 4), np.uint8)
        image[20:80, 30:70] = 255
        points, cells = wend.mesh_picture(image, outline='alpha', vertices=200)
        low, high = points.min(0), points.max(0)
        np.testing.assert_allclose(np.concatenate([low, high]), [28, 18, 72, 82], atol=1)

    def test_files(self):
        image = np.random.default_rng(1).integers(0, 65535, (9, 7, 3), np.uint16)
        wend.write_picture(str(self.folder / 'a.png'), image)
        np.testing.assert_array_equal(wend.read_picture(str(self.folder / 'a.png')), image)
        with self.assertRaisesRegex(wend.InvalidInput, 'i8'):
            wend.write_picture(str(self.folder / 'b.png'), image.astype(int))
        with self.assertRaises(wend.InvalidInput):
            wend.warp(image, [[0, 0], [1, 0], [0, 1]], [[0, 1, 2]], [[0, 0]])


class MeshTest(InFolder):
    def test_round_trip(self):
        points, cells = grid(3, 2, 1.5, 0.7)
        wend.write_mesh(self.folder / 'a.vtu', points, cells)
        again, same = wend.read_mesh(str(self.folder / 'a.vtu'))
        self.assertEqual(points.tobytes(), again.tobytes())
        self.assertEqual(cells.tolist(), same.tolist())
        tetrahedron = np.vstack([np.zeros(3), np.eye(3)])
        wend.write_mesh(str(self.folder / 'b.msh'), tetrahedron, [[0, 1, 2, 3]])
        again, same = wend.read_mesh(str(self.folder / 'b.msh'))
        self.assertEqual((again.shape, same.tolist()), ((4, 3), [[0, 1, 2, 3]]))

    def test_polygons(self):
        outer, hole = [(0, 0), (4, 0), (4, 2), (0, 2)], [(1, 0.5), (3, 0.5), (3, 1.5), (1, 1.5)]
        points, cells = wend.mesh_polygons([outer, hole], vertices=400, points=[(0.5, 1), (3.5, 1)])
        self.assertEqual(points[:2].tolist(), [[0.5, 1], [3.5, 1]])
        a, b, c = (points[cells[:, k]] for k in range(3))
        areas = np.cross(b - a, c - a) / 2
        self.assertTrue((areas > 0).all())
        self.assertAlmostEqual(areas.sum(), 8 - 2, 12)
        self.assertLess(abs(len(points) - 400), 80)

    def test_surface(self):
        points = np.vstack([np.zeros(3), 2 * np.eye(3)])
        triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
        x, cells = wend.fill_surface(points, triangles, max_volume=0.05, keep_surface=False)
        self.assertGreater(len(cells), 26)
        edges = x[cells[:, 1:]] - x[cells[:, :1]]
        self.assertAlmostEqual(abs(np.linalg.det(edges).sum() / 6), 8 / 6, 12)
        with self.assertRaisesRegex(wend.InvalidInput, 'open'):
            wend.fill_surface(points, triangles[1:])


class StubTest(unittest.TestCase):
    def test_stubs_name_all(self):
        """Checks that wend.pyi has exactly the names and arguments of the module."""
        import ast
        stub = pathlib.Path(__file__).parents[2] / 'python' / 'wend.pyi'
        tree = ast.parse(stub.read_text())
        written = {}
        for node in tree.body:
            if isinstance(node, ast.FunctionDef):
                written[node.name] = self.arguments(node)
            elif isinstance(node, ast.ClassDef):
                written[node.name] = None
                for member in node.body:
                    if isinstance(member, ast.FunctionDef):
                        written[f'{node.name}.{member.name}'] = self.arguments(member)
        real = {}
        for name, value in vars(wend).items():
            if name.startswith('_'):
                continue
            if isinstance(value, type):
                real[name] = None
                for member, what in vars(value).items():
                    if issubclass(value, Exception) or (member.startswith('_') and member not in ('__init__', '__bool__')):
                        continue
                    if name in ('Place', 'Movement', 'RunResult', 'Distortion') and member == '__init__':
                        continue
                    real[f'{name}.{member}'] = self.documented(what)
            elif callable(value):
                real[name] = self.documented(value)
        self.assertEqual(sorted(real), sorted(written))
        for name, arguments in real.items():
            if arguments is not None:
                self.assertEqual(written[name], arguments, name)

    @staticmethod
    def arguments(node):
        all = [a.arg for a in node.args.args + node.args.kwonlyargs]
        if node.args.kwarg:
            all.append('**' + node.args.kwarg.arg)
        return all

    @staticmethod
    def documented(value):
        """Returns the argument names in the first line of a pybind11 docstring; for a property only 'self'."""
        if isinstance(value, property):
            return ['self']
        line = value.__doc__.splitlines()[0]
        inside, names, depth, word = line[line.index('(') + 1:line.rindex(')')], [], 0, ''
        for letter in inside + ',':
            depth += letter in '([{'
            depth -= letter in ')]}'
            if letter == ',' and depth == 0:
                name = word.split(':')[0].split('=')[0].strip()
                if name not in ('', '*'):
                    names.append(name)
                word = ''
            else:
                word += letter
        return names

    def test_all_have_words(self):
        for name, value in vars(wend).items():
            if not name.startswith('_') and callable(value):
                self.assertTrue((value.__doc__ or '').strip(), name)


if __name__ == '__main__':
    unittest.main()
