# SPDX-License-Identifier: AGPL-3.0-or-later
"""Converts notebooks to pages with their texts and code and, where the code can be run, its output and figures."""

import contextlib
import io
import json
import os


def text_of(path, pictures, runs):
    """Returns a notebook as Markdown. With `runs`, the cells are run in order, which needs the module `wend` and
    Matplotlib; figures are written into the folder `pictures`."""
    with open(path) as file:
        cells = json.load(file)["cells"]
    stem, names, parts = os.path.splitext(os.path.basename(path))[0], {"__name__": "__main__"}, []
    for number, cell in enumerate(cells):
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            parts.append(source)
            continue
        parts.append(f"```python\n{source}\n```")
        if runs:
            parts += results(source, names, os.path.join(pictures, f"notebook-{stem}-{number}"))
    return "\n\n".join(parts) + "\n"


def results(source, names, picture):
    """Runs a cell and returns its output and figures as Markdown. Figures are written as PICTURE-K.png."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    printed, parts = io.StringIO(), []
    pyplot.show = lambda: None
    with contextlib.redirect_stdout(printed):
        exec(compile(source, picture, "exec"), names)
    if printed.getvalue():
        parts.append(f"```\n{printed.getvalue().rstrip()}\n```")
    for number in pyplot.get_fignums():
        name = f"{picture}-{number}.png"
        pyplot.figure(number).savefig(name, dpi=100, bbox_inches="tight")
        parts.append(f"![What this cell draws](pictures/{os.path.basename(name)})")
    pyplot.close("all")
    return parts
