#!/usr/bin/env python3
"""Writes the tables of docs/benchmarks.md, between its two marks, from what `wend bench -o FILE` wrote.

    scripts/benchmark_page.py FILE
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


def growth(rows):
    lines = ["### Growth", "", "Time grows as the number of vertices to the power p:", "",
             "| what | dimension | threads | p |", "| --- | --- | --- | --- |"]
    lines += [f"| {row['what']} | {row['dimension']} | {row['threads']} | {row['exponent']:.2f} |" for row in rows]
    return lines + [""]


def main():
    results = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    text = [BEGIN, f"Machine: {results['machine']}, {results['cores']} cores.", ""]
    for case in results["cases"]:
        text += table(case)
    text += growth(results.get("growth", [])) + [END]
    page = PAGE.read_text(encoding="utf-8")
    before, after = page.split(BEGIN)[0], page.split(END)[1]
    PAGE.write_text(before + "\n".join(text) + after, encoding="utf-8")


if __name__ == "__main__":
    main()
