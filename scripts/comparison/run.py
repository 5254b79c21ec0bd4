#!/usr/bin/python3
"""Runs Wend on the cases in this folder and writes docs/comparison.md and its picture. Needs python3-numpy.

    scripts/comparison/run.py [WEND]        (build/release/wend)

Seconds are processor time, so that other work on the machine hardly affects them. WEND_JOBS sets the number of concurrent
runs.

others.json holds the results of other programs on the same cases, measured once on the machine and with the versions that
it names; their code is not in this repository. Errors are computed here from the written meshes, not by Wend.
"""
import concurrent.futures
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # OpenBLAS's own threads beside those below may deadlock
import numpy as np  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE.parent))
from mesh_text import read_mesh  # noqa: E402
WEND = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/wend").resolve()
CASES = ["strip_5k_stretch", "strip_5k_bend90", "strip_5k_bend180", "square_5k_point", "square_5k_swap",
         "giraffe_5k_drink", "giraffe_5k_back", "bar_1k5_bend90", "bar_1k5_twist90", "bar_1k5_twist180"]
ENERGIES = ["equia", "metr", "akvf", "conf"]
WAYS = {"flow": [], "memory 10": ["--memory", "10"], "elastic": ["--memory", "elastic"], "settled": ["--settle"]}
PIECES = 6  # cubic pieces of a trajectory that is none of Wend's motions; the error is 1e-6 for half a turn


def rotation(angle, axis=None):
    c, s = math.cos(angle), math.sin(angle)
    if axis is None:
        return np.array([[c, -s], [s, c]])
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + s * cross + (1 - c) * cross @ cross


def place(way, points, t):
    """Returns the points of a handle at time t: an arc of constant length bends, or a polyline moves and rotates them."""
    dim = points.shape[1]
    if way["type"] == "arc":
        base, length, angle = np.array(way["base"], float), way["length"], t * way["angle"]
        end, middle = base.copy(), base.copy()
        end[0] += length
        middle[0] += length * (math.sin(angle) / angle if angle else 1)
        middle[1] += length * ((1 - math.cos(angle)) / angle if angle else 0)
        return middle + (points - end) @ rotation(angle, None if dim == 2 else (0, 0, 1)).T
    offset = np.array([np.interp(t, way["times"], column) for column in np.array(way["offsets"], float).T])
    turn = np.interp(t, way["times"], way["turn"])
    centre = np.array(way["center"]) + offset
    return centre + (points + offset - centre) @ rotation(turn, way.get("axis")).T


def handles_of(case, points):
    handles = [{"name": "held", "at": {"vertices": case["fixed"]}}]
    for k, one in enumerate(case["handles"]):
        way, ids = one["trajectory"], one["vertices"]
        motion = {"kind": way["type"], "time": [0, 1]}
        if way["type"] == "translate":
            motion["by"] = way["by"]
        elif way["type"] == "rotate":
            motion.update(centre=way["center"], angle=way["angle"], **({"axis": way["axis"]} if "axis" in way else {}))
        else:  # each vertex gets its own chain of cubics, each through four of its positions
            p = np.array([place(way, points[ids], t) for t in np.linspace(0, 1, 3 * PIECES + 1)])
            chain = p.copy()
            q = [p[k:len(p) - 3 + k:3] for k in range(4)]
            chain[1::3] = (-5 * q[0] + 18 * q[1] - 9 * q[2] + 2 * q[3]) / 6
            chain[2::3] = (2 * q[0] - 9 * q[1] + 18 * q[2] - 5 * q[3]) / 6
            for i, vertex in enumerate(ids):
                curve = {"kind": "curve", "interpolation": "bezier", "frame": "none", "time": [0, 1], "points": chain[:, i].tolist()}
                handles.append({"name": f"moved {k}.{vertex}", "at": {"vertices": [vertex]}, "motion": [curve]})
            continue
        handles.append({"name": f"moved {k}", "at": {"vertices": ids}, "motion": [motion]})
    return handles


def errors(rest, cells, pose):
    """Returns the paper's errors of the map from rest to pose, the number of inverted cells, and the largest stretch."""
    edges = lambda p: p[cells[:, 1:]] - p[cells[:, :1]]
    F = np.swapaxes(np.linalg.solve(edges(rest), edges(pose)), 1, 2)
    share = np.abs(np.linalg.det(edges(rest)))
    share /= share.sum()
    det, s = np.linalg.det(F), np.linalg.svd(F, compute_uv=False)
    pairs = [(0, 1)] if s.shape[1] == 2 else [(0, 1), (0, 2), (1, 2)]
    angle = sum(s[:, a] / s[:, b] + s[:, b] / s[:, a] - 2 for a, b in pairs)
    spread = sum((s[:, a] - s[:, b]) ** 2 for a, b in pairs)
    metric = ((s - 1) ** 2).sum(1) - (0.25 if s.shape[1] == 2 else 0.2) * spread
    return {"angle": share @ angle, "volume": share @ (det + 1 / det - 2), "metric": share @ metric,
            "flips": int((det <= 0).sum()), "stretch": s.max()}


def run(name, energy, way, folder):
    case = json.loads((HERE / "cases" / f"{name}.json").read_text())
    mesh = HERE / "cases" / case["mesh"]
    rest, cells = read_mesh(mesh)
    project = {"format": "wend", "version": 1, "domain": {"mesh": str(mesh)}, "material": {"phi": energy},
               "handles": handles_of(case, rest), "time": {"end": 1}}
    base = folder / f"{name}-{energy}-{way.split()[0]}"
    base.with_suffix(".wend").write_text(json.dumps(project))
    out = base.with_suffix(mesh.suffix)
    with open(base.with_suffix(".said"), "w+", encoding="utf8") as said:
        process = subprocess.Popen([WEND, "run", base.with_suffix(".wend"), "--quiet", "--threads", "1", "--backend", "cpu", "--fields", "none",
                                    "--mesh", out, "--report", base.with_suffix(".report"), *WAYS[way]], stderr=said)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            said.seek(0)
            return {"stopped": said.read().strip().removeprefix(f"wend: {base}.wend: ")}
    report = json.loads(base.with_suffix(".report").read_text())
    pose, _ = read_mesh(out)
    return {**errors(rest, cells, pose), "pose": pose, "seconds": usage.ru_utime + usage.ru_stime,
            "constraint": report["constraintError"]}


def number(value):
    return "0" if value == 0 else f"{value:.1e}".replace("e-0", "e-") if value < 1e-3 else f"{value:.3g}"


def best_other(rows):
    """Returns the row with the least F_metric that has no inverted cells and meets the constraints, or None. Ignores libigl's BBW."""
    sound = [r for r in rows if r["flips"] == 0 and r["constraint"] < 1e-4 and not r["program"].startswith("libigl BBW")]
    return min(sound, key=lambda r: r["metric"]) if sound else None


def table(name, results, others):
    lines = ["| | F_angle | F_area | F_metric | inverted | seconds |", "| --- | --- | --- | --- | --- | --- |"]
    for way in WAYS:
        for energy in ENERGIES:
            r = results[name, energy, way]
            if "stopped" in r:
                lines.append(f"| Wend {energy.upper()}, {way} | | | | | stops: {r['stopped']} |")
            else:
                lines.append(f"| Wend {energy.upper()}, {way} | " + " | ".join(number(r[k]) for k in ("angle", "volume", "metric"))
                             + f" | {r['flips']} | {r['seconds']:.2g} |")
    for r in others:
        bold = "**" if r is best_other(others) else ""
        lines.append(f"| {bold}{r['program']}{bold} | " + " | ".join(number(r[k]) for k in ("angle", "volume", "metric"))
                     + f" | {r['flips']} | {r['ms'] / 1000:.2g} |")
    return "\n".join(lines)


def outline(cells):
    """Returns the rings of the boundary, whose edges belong to one cell only."""
    count = {}
    for a, b, c in cells:
        for edge in ((a, b), (b, c), (c, a)):
            count[tuple(sorted(edge))] = count.get(tuple(sorted(edge)), 0) + 1
    return chained([edge for edge, n in count.items() if n == 1])


def chained(edges):
    """Returns the closed rings of vertices that the edges form."""
    after = {}
    for a, b in edges:
        after.setdefault(a, []).append(b)
        after.setdefault(b, []).append(a)
    rings, left = [], set(after)
    while left:
        ring = [min(left)]
        while ring[-1] in left:
            left.remove(ring[-1])
            ring.append(next((b for b in after[ring[-1]] if b in left), ring[0]))
        rings.append(ring[:-1])
    return rings


def picture(results):
    """Draws the outlines of the flat cases at their ends, settled over flow: a column for each energy, a row for each case."""
    cell, rows = 220, [c for c in CASES if not c.startswith("bar")]
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{cell * 4}" height="{cell * len(rows)}" font-family="sans-serif" font-size="11">',
           '<rect width="100%" height="100%" fill="#ffffff"/>']
    for y, name in enumerate(rows):
        case = json.loads((HERE / "cases" / f"{name}.json").read_text())
        rest, cells = read_mesh(HERE / "cases" / case["mesh"])
        rings = outline(cells)
        for x, energy in enumerate(ENERGIES):
            ends = {way: results[name, energy, way] for way in ("flow", "settled")}
            shown = [(r["pose"], colour) for (way, r), colour in zip(ends.items(), ("#9fb3e8", "#1f2126")) if "pose" in r]
            every = np.vstack([pose for pose, _ in shown] or [rest])
            low, size = every.min(0), max(np.ptp(every, 0))
            scale = (cell - 40) / size
            for pose, colour in shown:
                at = lambda p: f"{x * cell + 20 + (p[0] - low[0]) * scale:.1f} {(y + 1) * cell - 15 - (p[1] - low[1]) * scale:.1f}"
                path = "".join("M" + "L".join(at(pose[v]) for v in ring) + "Z" for ring in rings)
                svg.append(f'<path d="{path}" stroke="{colour}" fill="none" stroke-width="1"/>')
            svg.append(f'<text x="{x * cell + 8}" y="{y * cell + 16}" fill="#5c5f69">{name} {energy.upper()}</text>')
    (ROOT / "docs/pictures/comparison.svg").write_text("\n".join(svg + ["</svg>\n"]))


def summary(results, others):
    lines = ["| case | best other program | F_metric | Wend METR, flow | memory 10 | elastic | settled | settled / best |", "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    for name in CASES:
        best = best_other(others.get(name, []))
        ends = [results[name, "metr", way] for way in WAYS]
        texts = ["stops" if "stopped" in r else number(r["metric"]) for r in ends]
        ratio = f"{ends[-1]['metric'] / best['metric']:.3f}" if best and "metric" in ends[-1] else ""
        lines.append(f"| {name} | {best['program'] if best else 'none was tried'} | {number(best['metric']) if best else ''} | "
                     + " | ".join(texts) + f" | {ratio} |")
    return "\n".join(lines)


def main():
    others = json.loads((HERE / "others.json").read_text())
    jobs = [(name, energy, way) for name in CASES for energy in ENERGIES for way in WAYS]
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(int(os.environ.get("WEND_JOBS", os.cpu_count()))) as pool:
        results = {}
        for job, result in zip(jobs, pool.map(lambda job: run(*job, pathlib.Path(folder)), jobs)):
            results[job] = result
            print(*job, result.get("stopped") or f"F_metric {result['metric']:.5f} flips {result['flips']} {result['seconds']:.1f} s", flush=True)
    picture(results)
    page = (HERE / "page.md").read_text()
    page = page.replace("@SUMMARY@", summary(results, others["cases"])).replace("@SETTING@", others["setting"])
    page = page.replace("@TABLES@", "\n\n".join(f"### {name}\n{table(name, results, others['cases'].get(name, []))}" for name in CASES))
    (ROOT / "docs/comparison.md").write_text(page)


if __name__ == "__main__":
    main()
