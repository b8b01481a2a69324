#!/usr/bin/env python3
"""Roots of a polynomial with real coefficients, through ctypes, each proved.

    python3 roots.py -2 0 1           # t^2 - 2: coefficients, lowest first, degree at most 512
    python3 roots.py --real -2 0 1    # the real roots only, degree at most 512

All roots: prints, for each box, real or complex, number of roots in it, re, im, and the box's widths in re and
im.  Real roots: multiplicity, the root to the last place, and the doubles on both sides of it.
As a module: roots(c) and real_roots(c, lo, hi), for any sequence of numbers (list, tuple, array, numpy's).
The shared library is taken from beside this file if it is there, else from where the system looks: installed, or
in LD_LIBRARY_PATH (macOS: DYLD_LIBRARY_PATH; Windows: the folders of PATH).
"""
import ctypes as ct
import math
import pathlib
import sys

NAMES = {"darwin": "libalgsurf.1.dylib", "win32": "libalgsurf-1.dll"}  # elsewhere libalgsurf.so.1

if __name__ == "__main__" and sys.argv[1:] in (["--help"], ["-h"]):  # before the library is looked for
    print(__doc__.strip())
    sys.exit(0)


def library(platform=sys.platform):
    """The shared library's file on this platform."""
    name = NAMES.get(platform, "libalgsurf.so.1")
    beside = pathlib.Path(__file__).resolve().parent / name
    return str(beside) if beside.exists() else name


try:
    lib = ct.CDLL(library(), winmode=0)
except OSError as error:
    sys.exit(f"roots.py: {error}")
lib.algsurf_status_text.restype = ct.c_char_p


class ComplexRoot(ct.Structure):  # algsurf_complex_root in algsurf/allroots.h
    _fields_ = [(name, ct.c_double) for name in ("re_lo", "re_hi", "im_lo", "im_hi", "re", "im")]
    _fields_ += [("multiplicity", ct.c_int), ("real", ct.c_int)]


class RealRoot(ct.Structure):  # algsurf_real_root in algsurf/isolate.h
    _fields_ = [(name, ct.c_double) for name in ("root", "lo", "hi")]
    _fields_ += [("multiplicity", ct.c_int), ("sign", ct.c_int)]


def answer(status, found, count):
    if status < 0:
        raise ValueError(lib.algsurf_status_text(status).decode())
    return found[: count.value]


def roots(coefficients):
    """Disjoint boxes, each proved to hold `multiplicity` roots; `real` if its root is proved real."""
    n = len(coefficients)
    found, count = (ComplexRoot * max(n - 1, 1))(), ct.c_int()
    status = lib.algsurf_complex_roots_of_real((ct.c_double * n)(*coefficients), None, n - 1, found, ct.byref(count))
    return answer(status, found, count)


def real_roots(coefficients, lo=-math.inf, hi=math.inf):
    """All real roots in [lo,hi], in increasing order, each with its multiplicity: proved."""
    n = len(coefficients)
    found, count = (RealRoot * max(n - 1, 1))(), ct.c_int()
    status = lib.algsurf_real_roots((ct.c_double * n)(*coefficients), n - 1, ct.c_double(lo), ct.c_double(hi),
                                    found, len(found), ct.byref(count))
    return answer(status, found, count)


def row_of_root(r):
    kind = "real" if r.real else "complex"
    widths = f"{r.re_hi - r.re_lo:.2g}\t{r.im_hi - r.im_lo:.2g}"
    return f"{kind}\t{r.multiplicity}\t{r.re!r}\t{r.im!r}\t{widths}"


def row_of_real_root(r):
    return f"{r.multiplicity}\t{r.root!r}\t{r.lo!r}\t{r.hi!r}"


if __name__ == "__main__":
    only_real = sys.argv[1:2] == ["--real"]
    find, row_of = (real_roots, row_of_real_root) if only_real else (roots, row_of_root)
    try:
        found = find([float(a) for a in sys.argv[1 + only_real :]])
    except ValueError as error:
        print(f"usage: roots.py [--real] P0 P1 ... PN, lowest degree first; {str(error)[:200]}", file=sys.stderr)
        sys.exit(2)
    for r in found:
        print(row_of(r))
