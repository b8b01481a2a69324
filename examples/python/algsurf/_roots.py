"""Roots of polynomials: see the package."""
from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING, Any, Iterator, NamedTuple, Optional, Tuple, Union, overload

import numpy as np

from . import _algsurf
from ._coefficients import (Integers, complain, exact, floats, number, one, plain, polynomials, share,
                            thread_count)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._coefficients import Polynomial, Polynomials

    Ends = Union[float, NDArray[Any]]

# algsurf_real_root and algsurf_complex_root
_REAL = np.dtype((np.record, [("value", "f8"), ("lo", "f8"), ("hi", "f8"), ("multiplicity", "i4"),
                              ("sign", "i4")]))
_COMPLEX = np.dtype((np.record, [("re_lo", "f8"), ("re_hi", "f8"), ("im_lo", "f8"), ("im_hi", "f8"),
                                 ("value", "c16"), ("multiplicity", "i4"), ("is_real", "i4")]))
_SHOWN = 20  # roots, in a repr


class _Roots:
    """Roots of one polynomial, one after another; or of many, of shape (..., n).  There, a row that has fewer
    than n ends in places with multiplicity 0 and value nan, which are written when they are first asked for."""

    __slots__ = ("_held", "_count")
    _dtype: np.dtype[Any]
    _kind: str

    def __init__(self, held: Union[bytearray, NDArray[Any]], count: Optional[NDArray[np.intc]] = None) -> None:
        self._held, self._count = held, count  # count: of many polynomials, while what is behind it is anything

    @property
    def array(self) -> NDArray[Any]:
        """All of it as a structured array."""
        if not isinstance(self._held, np.ndarray):
            self._held = np.ndarray((len(self._held) // self._dtype.itemsize,), self._dtype, self._held)
        count = self._count
        if count is not None:
            none = np.zeros(2, self._dtype)  # behind the roots, and of what is refused
            none.view(np.float64).reshape(2, -1)[:, :-1] = np.nan  # the last double is two integers
            none["multiplicity"][1] = -1
            _algsurf.pad(self._held.view(np.uint8), count, none.view(np.uint8))
            self._count = None
        return self._held

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> NDArray[Any]:
        made = self.array["value"]
        made = np.repeat(made, self.multiplicity) if made.ndim == 1 else made.copy()
        return made if dtype is None else made.astype(dtype)

    def __len__(self) -> int:
        return len(self.array)

    def __getitem__(self, index: Any) -> Any:
        return self.array[index]

    def __iter__(self) -> Iterator[Any]:
        return iter(self.array)

    @property
    def shape(self) -> Tuple[int, ...]:
        return self.array.shape

    @property
    def multiplicity(self) -> NDArray[np.int32]:
        """1 for a simple root; 0 where there is no root; -1 for all of a polynomial that was refused."""
        return self.array["multiplicity"]

    @property
    def count(self) -> Any:
        """How many there are, each counted once: of one polynomial a number, of many an array."""
        if self._count is not None:
            return np.maximum(self._count, 0).astype(int).reshape(self._held.shape[:-1])  # type: ignore[union-attr]
        return (self.multiplicity > 0).sum(axis=-1)

    def _line(self, root: Any) -> str:
        times = f", {root['multiplicity']} times" if root["multiplicity"] > 1 else ""
        return f"{root['value'].item()!r}{times}"

    def __repr__(self) -> str:
        if self.array.ndim > 1:
            return f"<{self._kind} roots of polynomials: shape {self.shape}, {int(self.count.sum())} roots>"
        n = len(self)
        lines = [f"\n {self._line(root)}" for root in self.array[:_SHOWN]]
        more = [f"\n and {n - _SHOWN} more"] if n > _SHOWN else []
        return f"<{n or 'no'} {self._kind} root{'s' * (n != 1)}{':' * (n > 0)}{''.join(lines + more)}>"


class RealRoots(_Roots):
    """Real roots in increasing order, each once: what real_roots returns.

    `value` is within one unit in the last place of the root, `lo` and `hi` enclose it: equal, then this is the
    root exactly, or neighbouring doubles.  A root beyond the largest double has the largest double as its value,
    and an infinity as lo or hi.  `sign` is that of the polynomial just before the root.  r[i] is one
    of them, with the same names; r.array is all of them as a structured array, np.asarray(r) their values, each
    as often as its multiplicity.

    >>> for root in real_roots([0, 0, 5, -6, 1]):  # t^2 (t - 1) (t - 5)
    ...     print(root.value, root.multiplicity)
    0.0 2
    1.0 1
    5.0 1
    """

    __slots__ = ()
    _dtype = _REAL
    _kind = "real"

    @property
    def value(self) -> NDArray[np.float64]:
        return self.array["value"]

    @property
    def lo(self) -> NDArray[np.float64]:
        return self.array["lo"]

    @property
    def hi(self) -> NDArray[np.float64]:
        return self.array["hi"]

    @property
    def sign(self) -> NDArray[np.int32]:
        return self.array["sign"]


class ComplexRoots(_Roots):
    """Complex roots in increasing order of their real parts, each once: what complex_roots returns.

    `value` is the root, in a box from `lo` (below, left) to `hi` (above, right) that encloses it and no other.
    Ends of boxes beyond the largest double are infinite.
    `is_real` tells which are proved real; the other roots of a real polynomial are in conjugate pairs.  r[i] is
    one of them, its box in re_lo, re_hi, im_lo, im_hi; r.array is all of them as a structured array,
    np.asarray(r) their values, each as often as its multiplicity: what np.roots would say, and np.poly takes.

    >>> np.poly(complex_roots([-4, 0, 3, 0, 1]))
    array([ 1.,  0.,  3.,  0., -4.])
    """

    __slots__ = ()
    _dtype = _COMPLEX
    _kind = "complex"

    def _corner(self, re: str, im: str) -> NDArray[np.complex128]:
        corner = np.empty(self.shape, np.complex128)
        corner.real, corner.imag = self.array[re], self.array[im]
        return corner

    @property
    def value(self) -> NDArray[np.complex128]:
        return self.array["value"]

    @property
    def lo(self) -> NDArray[np.complex128]:
        return self._corner("re_lo", "im_lo")

    @property
    def hi(self) -> NDArray[np.complex128]:
        return self._corner("re_hi", "im_hi")

    @property
    def is_real(self) -> NDArray[np.bool_]:
        return np.asarray(self.array["is_real"] == 1)

    def _line(self, root: Any) -> str:
        value = root["value"].item() + 0  # no -0
        times = f", {root['multiplicity']} times" if root["multiplicity"] > 1 else ""
        return (f"{value.real!r}, real" if root["is_real"] else str(value).strip("()")) + times


class Value(NamedTuple):
    """A value and a bound: |value - exact value| <= bound."""

    value: Any
    bound: Any


def _ends(lo: Any, hi: Any, shape: Tuple[int, ...]) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
    """A number for all, or one for each polynomial."""
    low, high = floats("lo", lo), floats("hi", hi)
    if low.ndim or high.ndim:
        try:
            low, high = (np.ascontiguousarray(np.broadcast_to(end, shape)) for end in (low, high))
        except ValueError:
            raise ValueError("lo, hi: a number, or one for each polynomial, was expected") from None
    return low.reshape(-1), high.reshape(-1)


def _one(call: Any, c: Any, ends: Tuple[Any, ...]) -> Any:
    """What the call says of one polynomial, however that is given; or, of one that only integers hold, the bytes
    of its roots, the complex ones if there are no ends."""
    numbers: Any = one(c)
    found = call(numbers, *ends)
    if found is not None:
        return found
    numbers = plain(numbers)
    is_complex = numbers.is_complex if isinstance(numbers, Integers) else complex in map(type, numbers)
    if ends and is_complex:
        raise TypeError("complex coefficients: see complex_roots")
    if ends and number("lo", ends[0]) > number("hi", ends[1]):
        raise ValueError("lo is above hi")
    return _algsurf.roots_integers(*numbers, *ends) if isinstance(numbers, Integers) else call(numbers, *ends)


def _many(batch: NDArray[Any], shape: Tuple[int, ...], ends: Any, threads: int,
          strict: bool) -> Tuple[NDArray[Any], NDArray[np.intc]]:
    """The roots of many polynomials, and how many there are of each."""
    room, is_complex = batch.shape[1] - 1, batch.dtype.kind == "c"
    roots = np.empty((len(batch), max(room, 1)), _REAL if ends else _COMPLEX)
    count = np.empty(len(batch), np.intc)
    ends = _ends(ends[0], ends[1], shape) if ends else ()
    if ends and is_complex:
        raise TypeError("complex coefficients: see complex_roots")

    def work(a: int, b: int) -> Optional[Tuple[int, int]]:
        if not ends:
            im = [batch.imag[a:b]] if is_complex else []
            return _algsurf.complex_batch(batch.real[a:b], roots[a:b], count[a:b], *im)
        low, high = (end[a:b] if end.size > 1 else end for end in ends)
        return _algsurf.real_batch(batch[a:b], low, high, roots[a:b], count[a:b])

    if batch.dtype != object:
        refused = share(work, len(batch), threads, room)
        if strict:
            complain("polynomial", refused, "lo is above hi")
        return roots[:, :room].reshape(shape + (room,)), count
    call = _algsurf.real_roots if ends else _algsurf.complex_roots
    for i, row in enumerate(batch):
        try:
            found = np.frombuffer(_one(call, row, tuple(end[i % end.size] for end in ends)), roots.dtype)
            roots[i, : len(found)], count[i] = found, len(found)
        except ValueError as error:
            if strict:
                raise ValueError(f"polynomial {i}: {error}") from None
            count[i] = -1
    return roots[:, :room].reshape(shape + (room,)), count


def real_roots(c: Union[Polynomial, Polynomials], lo: Ends = -inf, hi: Ends = inf, *, threads: int = 1,
               strict: bool = True) -> RealRoots:
    """All real roots in [lo, hi], both ends included, in increasing order, each once with its multiplicity: proved.

    c        n + 1 coefficients, lowest degree first; or many polynomials, an array of shape (m, n + 1).
             Degrees up to 512
    lo, hi   floats; of many polynomials also arrays, a number for each
    threads  for many polynomials: 0, as many as there are processors
    strict   what becomes of many polynomials if one is refused, for a nan or because it is 0: an error with its
             number; or, if False, its roots are nan, with multiplicity -1

    >>> real_roots([-4, 12, -13, 6, -1])  # -(t - 1)^2 (t - 2)^2
    <2 real roots:
     1.0, 2 times
     2.0, 2 times>
    >>> many = real_roots(np.array([[-2.0, 0, 1], [1, 0, 1]]))
    >>> many
    <real roots of polynomials: shape (2, 2), 2 roots>
    >>> many.value
    array([[-1.41421356,  1.41421356],
           [        nan,         nan]])
    >>> many.count
    array([2, 0])
    """
    if threads != 1:
        thread_count(threads)
    found = _algsurf.real_roots(c, lo, hi)
    if found is not None:
        return RealRoots(found)
    many = polynomials(c)
    if many is None:
        return RealRoots(_one(_algsurf.real_roots, c, (lo, hi)))
    return RealRoots(*_many(*many, (lo, hi), threads, strict))


def complex_roots(c: Union[Polynomial, Polynomials], *, threads: int = 1, strict: bool = True) -> ComplexRoots:
    """All complex roots, each once with its multiplicity, in a box of its own as narrow as doubles allow: proved.

    c        n + 1 coefficients, real or complex, lowest degree first; or many polynomials, an array of shape
             (m, n + 1).  Degrees up to 512
    threads, strict  as for real_roots

    >>> r = complex_roots([-4, 0, 3, 0, 1])  # (t^2 - 1) (t^2 + 4)
    >>> r
    <4 complex roots:
     -1.0, real
     -2j
     2j
     1.0, real>
    >>> r.value[r.is_real].real
    array([-1.,  1.])
    >>> print(complex_roots([2j, 0, 1])[0].value)  # a square root of -2i
    (-1+1j)
    """
    if threads != 1:
        thread_count(threads)
    found = _algsurf.complex_roots(c)
    if found is not None:
        return ComplexRoots(found)
    many = polynomials(c)
    if many is None:
        return ComplexRoots(_one(_algsurf.complex_roots, c, ()))
    return ComplexRoots(*_many(*many, (), threads, strict))


@overload
def count_roots(c: Polynomial, lo: float = ..., hi: float = ..., *, threads: int = ...) -> Any: ...
@overload
def count_roots(c: Polynomials, lo: Ends = ..., hi: Ends = ..., *, threads: int = ...) -> NDArray[np.int_]: ...
def count_roots(c: Any, lo: Any = -inf, hi: Any = inf, *, threads: int = 1) -> Any:
    """How many different real roots there are in [lo, hi], both ends included: proved.  Of many polynomials an
    array, as real_roots(...).count.

    >>> count_roots([0, 0, 5, -6, 1]), count_roots([0, 0, 5, -6, 1], 0.5, 5)
    (3, 2)
    """
    if threads != 1:
        thread_count(threads)
    found = _algsurf.count_roots(c, lo, hi)
    if found is not None:
        return found
    count = real_roots(c, lo, hi, threads=threads).count
    return count if np.ndim(count) else int(count)


@overload
def first_root(c: Polynomial, lo: float = ..., hi: float = ..., *, threads: int = ...) -> Any: ...
@overload
def first_root(c: Polynomials, lo: Ends = ..., hi: Ends = ..., *, threads: int = ...) -> NDArray[np.float64]: ...
def first_root(c: Any, lo: Any = -inf, hi: Any = inf, *, threads: int = 1) -> Any:
    """The smallest real root in [lo, hi], both ends included; infinity if there is none: proved.  Of many
    polynomials an array.  The root is off by 1e-12 of hi - lo and a rounding at most, and has the bits that
    real_roots gives if lo or hi is infinite.

    >>> first_root([6, -5, 1], 0, 10), first_root([6, -5, 1], 4, 10)
    (2.0, inf)
    """
    if threads != 1:
        thread_count(threads)
    found = _algsurf.first_root(c, lo, hi)
    if found is not None:
        return found
    many = polynomials(c)
    if many is None:
        found = _one(_algsurf.first_root, c, (lo, hi))
        return found if isinstance(found, float) else next(iter(RealRoots(found).value.tolist()), inf)
    batch, shape = many
    if batch.dtype.kind in "cO":
        roots = real_roots(c, lo, hi)
        return np.where(roots.count > 0, roots.value[..., :1].sum(axis=-1), inf)
    out, state, (low, high) = np.empty(len(batch)), np.empty(len(batch), np.uint8), _ends(lo, hi, shape)

    def work(a: int, b: int) -> Optional[Tuple[int, int]]:
        own = slice(a, b) if low.size > 1 else slice(None)
        return _algsurf.first_batch(batch[a:b], low[own], high[own], out[a:b], state[a:b])

    complain("polynomial", share(work, len(batch), threads, batch.shape[1]), "lo is above hi")
    return out.reshape(shape)


def evaluate(c: Polynomial, x: ArrayLike) -> Value:
    """The value of one polynomial at x, a float or an array of any shape, computed as if in doubled precision,
    with a bound on its error.  Coefficients that are no doubles are rounded, which the bound allows for.

    >>> value, bound = evaluate([-2, 0, 1], 1.5)
    >>> value, bound < 1e-16
    (0.25, True)
    >>> evaluate(["0.1", 1], [0, 1]).value
    array([0.1, 1.1])
    """
    if polynomials(c) is not None:
        raise TypeError("evaluate takes one polynomial")
    numbers = one(c)
    if any(isinstance(a, (complex, np.complexfloating)) for a in numbers):
        raise TypeError("evaluate: real coefficients only")
    exactly = [exact(a) for a in numbers]
    if not exactly:
        raise ValueError("a polynomial without coefficients")
    doubles = np.array([float(f) for f in exactly])
    errors = [abs(f - exact(d)) for f, d in zip(exactly, doubles)]
    radii = np.array([np.nextafter(float(e), inf) if e else 0 for e in errors] if any(errors) else [], np.float64)
    at = floats("x", x)
    flat, out = np.ascontiguousarray(at).reshape(-1), np.empty((2, at.size))
    complain("place", share(lambda a, b: _algsurf.evaluate(doubles, radii, flat[a:b], out[0, a:b], out[1, a:b]),
                            at.size, 1))
    value, bound = out.reshape((2,) + at.shape)
    return Value(value, bound) if at.ndim else Value(value.item(), bound.item())
