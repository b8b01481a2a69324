"""The examples in the docstrings of the package and on pages; of modules that are not there, none are run.

    doctests.py PAGE...
"""
import doctest
import importlib
import re
import sys

import numpy as np

import algsurf
from algsurf import _coefficients, _roots, _surface

failed = attempted = 0
for module in (algsurf, _roots, _surface, _coefficients):
    names = {**vars(algsurf), "np": np, **vars(module)}
    result = doctest.testmod(module, globs=names)
    failed, attempted = failed + result.failed, attempted + result.attempted

names = {}
absent = set()
for name in ("scipy", "scipy.optimize", "sympy", "mpmath"):
    try:
        names[name.split(".")[0]] = importlib.import_module(name.split(".")[0])
        importlib.import_module(name)
    except ImportError:
        absent.add(name.split(".")[0])
runner = doctest.DocTestRunner()
for page in sys.argv[1:]:
    with open(page, encoding="utf-8") as file:
        text = file.read()
    for block in re.finditer(r"```pycon\n(.*?)```", text, re.S):
        if any(re.search(rf"\b{name}\.", block.group(1)) for name in absent):
            continue
        line = text.count("\n", 0, block.start(1))
        test = doctest.DocTestParser().get_doctest(block.group(1), names, page, page, line)
        runner.run(test, clear_globs=False)
        names.update(test.globs)
print(f"{attempted + runner.tries} examples; not there: {', '.join(sorted(absent)) or 'nothing'}")
sys.exit(failed + runner.failures > 0 or runner.tries < 30)
