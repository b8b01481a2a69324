#!/usr/bin/env python3
"""All roots of a polynomial with real coefficients, enclosed and counted, through ctypes.

    python3 roots.py -2 0 1         # t^2 - 2: coefficients, lowest first, degree at most 64

prints, for each box: real or complex, number of roots in it, re, im, and the box's widths in re and im.
The shared library is looked for where the system looks: installed, or in LD_LIBRARY_PATH.
"""
import ctypes as ct
import sys

try:
    lib = ct.CDLL("libalgsurf.so.1")
except OSError as error:
    sys.exit(f"roots.py: {error}")
lib.algsurf_status_text.restype = ct.c_char_p


class Enclosure(ct.Structure):  # algsurf_enclosure in algsurf/allroots.h
    _fields_ = [(name, ct.c_double) for name in ("re_lo", "re_hi", "im_lo", "im_hi", "re", "im")]
    _fields_ += [("multiplicity", ct.c_int), ("real", ct.c_int)]


def roots(coefficients):
    """Disjoint boxes, each proved to hold `multiplicity` roots; `real` if its root is proved real."""
    n = len(coefficients)
    found, count = (Enclosure * max(n - 1, 1))(), ct.c_int()
    status = lib.algsurf_roots_real((ct.c_double * n)(*coefficients), None, n - 1, found, ct.byref(count))
    if status < 0:
        raise ValueError(lib.algsurf_status_text(status).decode())
    return found[: count.value]


if __name__ == "__main__":
    try:
        found = roots([float(a) for a in sys.argv[1:]])
    except ValueError as error:
        print(f"usage: roots.py P0 P1 ... PN, lowest degree first; {str(error)[:200]}", file=sys.stderr)
        sys.exit(2)
    for r in found:
        kind = "real" if r.real else "complex"
        widths = f"{r.re_hi - r.re_lo:.2g}\t{r.im_hi - r.im_lo:.2g}"
        print(f"{kind}\t{r.multiplicity}\t{r.re!r}\t{r.im!r}\t{widths}")
