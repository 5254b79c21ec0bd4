#!/usr/bin/env python3
"""Runs Python examples, each in a separate folder that contains the samples: all examples of a page, or the cells of a notebook in order.

usage: run_examples.py SAMPLES PAGE|NOTEBOOK…, with the folder of the module in PYTHONPATH. Exits with 77, which skips the
test, if there are notebooks but no Matplotlib.
"""
import importlib.util
import json
import pathlib
import re
import subprocess
import sys
import tempfile


def examples_of(file):
    text = file.read_text()
    if file.suffix == '.ipynb':
        cells = [''.join(cell['source']) for cell in json.loads(text)['cells'] if cell['cell_type'] == 'code']
        return ['import matplotlib\nmatplotlib.use("Agg")\n' + '\n'.join(cells)]
    return re.findall(r'^```python\n(.*?)^```$', text, re.MULTILINE | re.DOTALL)


def run(file, example, samples):
    with tempfile.TemporaryDirectory() as folder:
        for sample in samples.iterdir():
            (pathlib.Path(folder) / sample.name).symlink_to(sample)
        # Warnings are not errors in notebooks, because Debian's Matplotlib warns about NumPy.
        strict = [] if file.suffix == '.ipynb' else ['-W', 'error']
        done = subprocess.run([sys.executable, *strict, '-c', example], cwd=folder)
        if done.returncode != 0:
            sys.exit(f'{file}: this example ends with {done.returncode}:\n{example}')


samples, files = pathlib.Path(sys.argv[1]).resolve(), [pathlib.Path(name) for name in sys.argv[2:]]
if not files:
    sys.exit('no examples are given')
if any(file.suffix == '.ipynb' for file in files) and importlib.util.find_spec('matplotlib') is None:
    print('skipped: python3-matplotlib is not installed')
    sys.exit(77)
for file in files:
    examples = examples_of(file)
    if not examples:
        sys.exit(f'{file}: no example is found')
    for example in examples:
        run(file, example, samples)
