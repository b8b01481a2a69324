"""Times beside those of the library alone and of np.roots; the limits are loose, since other programs may run.

    speed.py SPEED       SPEED: the program made of speed.c
"""
import subprocess
import sys
import tempfile
import time

import numpy as np

import algsurf

CALLS, ROWS, TAKES, FEW = 10_000, 100_000, 3, 1000


def least(work, takes=TAKES):
    times = []
    for _ in range(takes):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return min(times)


def repeat(call, c, count):
    for _ in range(count):
        call(c)


rows = np.random.default_rng(1).standard_normal((ROWS, 7))
one = rows[0].tolist()
work = [lambda: repeat(algsurf.real_roots, one, CALLS), lambda: repeat(algsurf.complex_roots, one, CALLS),
        lambda: algsurf.real_roots(rows), lambda: algsurf.real_roots(rows, -1, 1),
        lambda: algsurf.complex_roots(rows)]
with tempfile.NamedTemporaryFile() as file:
    rows.tofile(file.name)
    alone, here = [np.inf] * len(work), [np.inf] * len(work)
    for _ in range(5):  # in turns: what disturbs one disturbs the other
        said = subprocess.run([sys.argv[1], file.name, str(CALLS), str(ROWS)], stdout=subprocess.PIPE, check=True)
        alone = [min(a, float(b)) for a, b in zip(alone, said.stdout.split())]
        here = [min(a, least(w)) for a, w in zip(here, work)]
alone, here = ([t / n * 1e6 for t, n in zip(times, [CALLS] * 2 + [ROWS] * 3)] for times in (alone, here))
numpy_one = least(lambda: repeat(np.roots, one, FEW)) / FEW * 1e6
numpy_many = least(lambda: [np.roots(c) for c in rows[:FEW]]) / FEW * 1e6

bad = 0
for i, name in enumerate(("real_roots", "complex_roots")):
    over = here[i] - alone[i]
    print(f"{name}, one polynomial: {here[i]:.2f} us; C {alone[i]:.2f}, {over:.2f} more; "
          f"np.roots {numpy_one:.1f}, {numpy_one / here[i]:.0f} times as long")
    bad += over > 4 or numpy_one < 5 * here[i]
for i, name in enumerate(("real_roots", "real_roots in [-1, 1]", "complex_roots"), 2):
    print(f"{name}, {ROWS} polynomials: {here[i]:.3f} us each; C {alone[i]:.3f}, ratio {here[i] / alone[i]:.2f}; "
          f"np.roots {numpy_many:.1f}, {numpy_many / here[i]:.0f} times as long")
    bad += here[i] > 1.6 * alone[i] or numpy_many < 8 * here[i]
sys.exit("a time is out of its limit" if bad else 0)
