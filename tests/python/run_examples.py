#!/usr/bin/env python3
"""Runs every example of a page in Python, each in a folder of its own with the samples in it.

usage: run_examples.py PAGE SAMPLES, with the folder of the module in PYTHONPATH.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

page, samples = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
examples = re.findall(r'^```python\n(.*?)^```$', page.read_text(), re.MULTILINE | re.DOTALL)
if len(examples) < 3:
    sys.exit(f'{page}: only {len(examples)} examples were found')
for example in examples:
    with tempfile.TemporaryDirectory() as folder:
        for sample in samples.iterdir():
            (pathlib.Path(folder) / sample.name).symlink_to(sample)
        done = subprocess.run([sys.executable, '-W', 'error', '-c', example], cwd=folder)
        if done.returncode != 0:
            sys.exit(f'{page}: this example ends with {done.returncode}:\n{example}')
