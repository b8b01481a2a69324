"""Roots of polynomials and algebraic surfaces: libalgsurf for Python.

    real_roots(c, lo, hi)     all real roots in an interval, with multiplicities
    complex_roots(c)          all complex roots
    count_roots(c, lo, hi)    how many different real roots
    first_root(c, lo, hi)     the smallest real root
    evaluate(c, x)            values with bounds on their errors
    Surface(equation, a=1.2)  an algebraic surface: first hits of rays, pictures, meshes
    png(pixels)               a picture as the bytes of a file

Roots, counts and hits are proved; `evaluate` and `value_and_bound` give bounds; the other numbers and pictures
are floats.

A polynomial is its coefficients, lowest degree first: [-2, 0, 1] is t^2 - 2.

>>> import algsurf
>>> r = algsurf.real_roots([-2, 0, 1])
>>> r
<2 real roots:
 -1.4142135623730951
 1.4142135623730951>
>>> print(r[1].lo, r[1].hi)  # neighbouring doubles, with the root between them: proved
1.414213562373095 1.4142135623730951

Coefficients are exact: floats as they are, whole numbers of any length, Fractions, Decimals, and text such
as "0.1" or "1/3".  This is (t - 1)(t - 2)(t - 3) / 10, and no root is rounded:

>>> algsurf.real_roots(["-0.6", "1.1", "-0.6", "0.1"]).value
array([1., 2., 3.])

An array of shape (m, n + 1), or a list of m lists, is m polynomials of degree n, solved many at once; answers
have a row for each.  A call lets other threads run.  Batches take threads=, the number of threads, 0 for as
many as there are processors; the answers have the same bits for any number.

Errors are ValueError for what is no polynomial, equation or ray, OverflowError for what leaves the range of
floats, MemoryError, and TypeError for what is no number.
"""
from . import _algsurf
from ._roots import ComplexRoots, RealRoots, Value, complex_roots, count_roots, evaluate, first_root, real_roots
from ._mesh import Mesh
from ._surface import Hits, Surface, png

__version__: str = _algsurf.version()
__all__ = ["ComplexRoots", "Hits", "Mesh", "RealRoots", "Surface", "Value", "complex_roots", "count_roots", "evaluate",
           "first_root", "png", "real_roots"]
