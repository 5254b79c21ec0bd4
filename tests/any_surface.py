#!/usr/bin/env python3
"""Bends every surface of some Debian packages by a right angle and writes a table of the results.

    tests/any_surface.py build/release/wend [--folder DIR] [--table docs/any-surface.md] [--limit N]

The packages are fetched with apt-get into DIR (kept for the next time) and unpacked there; nothing is installed. Every
model gets two handles, at both ends of its longest side, that rotate by 45° against each other, 90° in all. The mesh aims
at 2,000 vertices, one thread is used, and the result is exported as OBJ and read back here. If the exact surface is too
coarse to bend that far, a cage is requested, as a user would do."""
import argparse
import gzip
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tarfile
import time

PACKAGES = ["libcgal-demo", "geomview", "meshlab", "libvtk9-dev", "vtk9-examples", "openscad-testing-data",
            "libigl-dev", "pcl-tools", "admesh"]
KINDS = {".off", ".obj", ".ply", ".stl"}
AIM = 2000
SECONDS = 300


def fetch(folder):
    """Fetches the packages that are available and returns the paths of their models, without duplicates."""
    folder.mkdir(parents=True, exist_ok=True)
    for package in PACKAGES:
        place = folder / package
        if place.exists():
            continue
        got = subprocess.run(["apt-get", "download", package], cwd=folder, capture_output=True)
        debs = sorted(folder.glob(package + "_*.deb"))
        if got.returncode != 0 or not debs:
            print(f"{package}: not there", file=sys.stderr)
            continue
        subprocess.run(["dpkg", "-x", debs[-1], place], check=True)
        debs[-1].unlink()
        for archive in place.rglob("*.tar.gz"):
            with tarfile.open(archive) as inside:
                inside.extractall(archive.parent / archive.name[:-7], filter="data")
        for packed in place.rglob("*.gz"):
            if packed.with_suffix("").suffix.lower() in KINDS:
                with gzip.open(packed) as source, open(packed.with_suffix(""), "wb") as target:
                    shutil.copyfileobj(source, target)
    files = [p for p in sorted(folder.rglob("*")) if p.suffix.lower() in KINDS and p.is_file()]
    seen, models = set(), []
    for path in files:
        content = path.read_bytes()
        if content not in seen:
            seen.add(content)
            models.append(path)
    return models


def project(model, low, high, cage):
    """Returns a project that bends the middle line to a quarter of a circle: both ends rotate by 45°, each about the
    point that takes it to the end of this arc."""
    size = [h - l for l, h in zip(low, high)]
    axis = size.index(max(size))
    across, around = (axis + 1) % 3, (axis + 2) % 3
    half, angle = size[axis] / 2, math.pi / 4
    radius = half / angle
    # The rotation takes (0, half) to the end of the arc, in the plane of the bend; the pivot is its fixed point.
    x, y = radius * (1 - math.cos(angle)), radius * math.sin(angle)
    x, y = x - half * math.sin(angle), y - half * math.cos(angle)
    c, s = 1 - math.cos(angle), math.sin(angle)
    pivot = ((c * x + s * y) / (c * c + s * s), (c * y - s * x) / (c * c + s * s))
    margin = max(size)
    parts = []
    for end in (0, 1):
        box_low, box_high = [l - margin for l in low], [h + margin for h in high]
        if end == 0:
            box_high[axis] = low[axis] + 0.05 * size[axis]
        else:
            box_low[axis] = high[axis] - 0.05 * size[axis]
        side = 2 * end - 1
        centre = [(l + h) / 2 for l, h in zip(low, high)]
        centre[across] += pivot[0]
        centre[axis] += side * pivot[1]
        # A rotation about the third axis takes the first axis towards the second, the direction of the bend.
        turn = {"kind": "rotate", "centre": centre, "axis": [float(k == around) for k in range(3)],
                "angle": side * angle}
        parts.append({"at": {"region": {"box": {"min": box_low, "max": box_high}}}, "motion": [turn]})
    domain = {"surface": str(model), "vertices": AIM}
    if cage:
        domain["cage"] = True
    return {"format": "wend", "version": 1, "domain": domain, "handles": parts,
            "integration": {"method": "adams", "tolerance": 1e-3}}


def call(arguments, folder):
    try:
        done = subprocess.run(arguments, cwd=folder, capture_output=True, text=True, timeout=SECONDS)
        return done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired:
        return -1, "", f"more than {SECONDS} s"


def run(wend, model, low, high, cage, folder):
    """Runs a project and returns the exit code, the last line of the error message and the seconds."""
    (folder / "bend.wend").write_text(json.dumps(project(model, low, high, cage)))
    for old in ("bent.obj", "report.json"):
        (folder / old).unlink(missing_ok=True)
    began = time.monotonic()
    code, _, error = call([wend, "run", "bend.wend", "--mesh", "bent.obj", "--report", "report.json",
                           "--threads", "1", "--quiet", "--backend", "cpu"], folder)
    return code, error.strip().splitlines()[-1] if error.strip() else "", time.monotonic() - began


def exported(path, vertices):
    """Returns whether the OBJ file has as many finite vertices as the model."""
    places = [line.split()[1:4] for line in open(path) if line.startswith("v ")]
    return len(places) == vertices and all(math.isfinite(float(x)) for place in places for x in place)


def bend(wend, model, folder):
    """Returns a row of the table and the kind of the result, or None for a file without a surface."""
    code, out, error = call([wend, "info", model, "--json"], folder)
    if code != 0:
        return [model.name, "", "", "", "", error.strip().split(": ", 2)[-1]], "unreadable"
    info = json.loads(out)
    if info["kind"] not in ("surface", "planar mesh") or info.get("triangles", info.get("cells", 0)) == 0:
        return None
    box = info.get("box")
    flat = box is None
    if flat:
        points = [[float(x) for x in line.split()[:3]] for line in open(model, errors="replace")
                  if len(line.split()) >= 3 and line.split()[0].lstrip("-").replace(".", "", 1).isdigit() and "." in line]
        points = points[:info["vertices"]]  # drops lines of coloured cells, which look like points
        if not points:
            return None
        low = [min(p[k] for p in points) for k in range(3)]
        high = [max(p[k] for p in points) for k in range(3)]
    else:
        low, high = box["low"], box["high"]
    triangles = info.get("triangles", info.get("cells", 0))
    asked = "it lies in a plane" if flat else ""
    code, error, seconds = run(wend, model, low, high, bool(asked), folder)
    if code != 0 and not asked:
        asked = "as asked: " + (error.replace(str(model), model.name).split(" cannot go on: ")[-1].split(" near ")[0] if error else f"code {code}")
        code, error, more = run(wend, model, low, high, True, folder)
        seconds += more
    if code != 0:
        return [model.name, triangles, "", "", f"{seconds:.1f}", error or code], "failed"
    report = json.loads((folder / "report.json").read_text())
    good = exported(folder / "bent.obj", info["vertices"]) and report["flips"] == 0
    cage = report.get("cage")
    why = (cage.get("why", asked) if cage else "").replace("the surface bounds no volume: ", "")
    row = [model.name, triangles, "cage" if cage else "exact", report["vertices"], f"{seconds:.1f}",
           why.replace("it cannot be meshed as it is: ", "").split("; ")[0][:110]]
    return row, ("cage" if cage else "exact") if good else "failed"


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    arguments.add_argument("wend", type=pathlib.Path)
    arguments.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("/tmp/wend-any-surface"))
    arguments.add_argument("--table", type=pathlib.Path)
    arguments.add_argument("--limit", type=int, default=0)
    options = arguments.parse_args()
    models = fetch(options.folder / "packages")
    work = options.folder / "work"
    work.mkdir(exist_ok=True)
    rows, counts = [], {}
    for model in models[:options.limit or None]:
        found = bend(options.wend.resolve(), model.resolve(), work)
        if found is None:
            continue
        row, kind = found
        counts[kind] = counts.get(kind, 0) + 1
        rows.append(row)
        print(kind, *row, sep="\t", flush=True)
    print(counts, file=sys.stderr)
    if options.table:
        lines = ["| model | triangles | bent as | vertices | seconds | why a cage |", "| --- | --- | --- | --- | --- | --- |"]
        lines += ["| " + " | ".join(str(cell).replace("|", "/").replace("\n", " ") for cell in row) + " |" for row in rows]
        options.table.write_text("\n".join(lines) + "\n")
    return 1 if set(counts) - {"exact", "cage", "unreadable"} else 0


if __name__ == "__main__":
    sys.exit(main())
