#!/usr/bin/env python3
"""Writes the tables between the two marks of docs/benchmarks.md from the results of `wend bench -o FILE`.

    scripts/benchmark_page.py FILE [FILE …]

The first file provides all tables; files for other instruction sets (WEND_SIMD) add one short table each.
"""
import json
import pathlib
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "benchmarks.md"
BEGIN, END = "<!-- tables -->", "<!-- end of tables -->"


def duration(seconds):
    if seconds < 0.1:
        return f"{1e3 * seconds:.3g} ms"
    return f"{1e3 * seconds:.0f} ms" if seconds < 10 else f"{seconds:.1f} s"


def cell(name, value):
    if name == "error":
        return f"{name} {value:.1e}"
    return f"{name} {value:.3g}" if value < 1000 else f"{name} {value:.0f}"


def table(case):
    size = f": {case['vertices']} vertices, {case['cells']} cells" if case["vertices"] else ""
    lines = [f"### {case['name']}{size}", "", "| what | threads | median | beside |", "| --- | --- | --- | --- |"]
    for row in case["rows"]:
        figures = ", ".join(cell(name, value) for name, value in row.get("figures", {}).items())
        lines.append(f"| {row['what']} | {row['threads']} | {duration(row['seconds'])} | {figures} |")
    return lines + [""]


def glance(cases):
    """Returns the summary table: ratios to the paper's scheme in the same run, and the frame time of a drag."""
    lines = ["### At a glance", "",
             "| case | vertices | ten RK4 steps, 1 thread | all | soonest at 1e-4, all threads | a drag's frame | at EQUIA |",
             "| --- | --- | --- | --- | --- | --- | --- |"]
    for case in cases:
        rows = case["rows"]
        faster = {(row["what"], row["threads"]): row["figures"]["times the paper's speed"]
                  for row in rows if "times the paper's speed" in row.get("figures", {})}
        ends = [(ratio, what) for (what, threads), ratio in faster.items() if what.startswith("to 1e-4") and threads > 1]
        if not ends:
            continue
        ten = [ratio for (what, _), ratio in sorted(faster.items(), key=lambda row: row[0][1]) if what == "ten RK4 steps"]
        best, name = max(ends)
        frames = {row["what"]: duration(row["seconds"]) for row in rows
                  if row["what"].startswith("drag frame, with") and row["threads"] > 1}
        plain, equia = (next((time for what, time in frames.items() if what.endswith("EQUIA") == near), "")
                        for near in (False, True))
        lines.append(f"| {case['name']} | {case['vertices']} | {ten[0]:.1f} × | {ten[-1]:.1f} × | "
                     f"{best:.1f} × ({name.removeprefix('to 1e-4 by ')}) | {plain} | {equia} |")
    return lines + ["", "Ratios: how many times faster than the paper's scheme.", ""]


def growth(rows):
    lines = ["### Growth", "", "Time grows as the number of vertices to the power p:", "",
             "| what | dimension | threads | p |", "| --- | --- | --- | --- |"]
    lines += [f"| {row['what']} | {row['dimension']} | {row['threads']} | {row['exponent']:.2f} |" for row in rows]
    return lines + [""]


def short(results):
    """Returns the table of another instruction set: the factorization beside CHOLMOD's and the whole flow beside the
    paper's, with one thread."""
    rows = [(case, {(row["what"], row["threads"]): row for row in case["rows"]}) for case in results["cases"]]
    lines = [f"### On {results['simd']}", "", "| case | CHOLMOD | factor, double | factor, single | ten RK4 steps, 1 thread |",
             "| --- | --- | --- | --- | --- |"]
    for case, found in rows:
        cholmod = next((row for (what, _), row in found.items() if what.startswith("factor, CHOLMOD")), None)
        own = [found.get((f"factor, {kind} precision", 1)) for kind in ("double", "single")]
        steps = found.get(("ten RK4 steps", 1))
        if cholmod and all(own) and steps:
            times = " | ".join(duration(row["processorSeconds"]) for row in [cholmod] + own)
            lines.append(f"| {case['name']} | {times} | {processorRatio(found, steps):.1f} × |")
    return lines + [""]


def processorRatio(found, steps):
    return found[("ten RK4 steps, paper's scheme", 1)]["processorSeconds"] / steps["processorSeconds"]


def main():
    results, *others = [json.loads(pathlib.Path(name).read_text(encoding="utf-8")) for name in sys.argv[1:]]
    text = [BEGIN, f"Machine: {results['machine']}, {results['cores']} cores, instruction set {results['simd']}.", ""]
    text += glance(results["cases"])
    for case in results["cases"]:
        text += table(case)
    text += growth(results.get("growth", []))
    for other in others:
        text += short(other)
    text.append(END)
    page = PAGE.read_text(encoding="utf-8")
    before, after = page.split(BEGIN)[0], page.split(END)[1]
    PAGE.write_text(before + "\n".join(text) + after, encoding="utf-8")


if __name__ == "__main__":
    main()
