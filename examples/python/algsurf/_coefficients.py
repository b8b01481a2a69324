"""Coefficients as users write them, made doubles or integers without any rounding; work shared among threads."""
from __future__ import annotations

import math
import numbers
import operator
import os
import re
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Callable, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _algsurf

if TYPE_CHECKING:
    from decimal import Decimal
    from numpy.typing import NDArray

    Number = Union[float, Fraction, Decimal, str, np.number[Any]]
    Polynomial = Union[Sequence[Number], NDArray[Any]]
    Polynomials = Union[Sequence[Sequence[Number]], NDArray[Any]]

ARGUMENT, NOT_FINITE = -1, -2  # ALGSURF_E_ARGUMENT, ALGSURF_E_NOT_FINITE
WHOLE = 2**53  # all whole numbers up to this are doubles
DIGITS = 320_000  # of a decimal exponent, at most: integers have 2^20 bits


def _from_text(text: str) -> Fraction:
    power = re.search(r"[eE]([-+]?[0-9_]+)\s*$", text)
    if power and abs(int(power.group(1))) > DIGITS:
        raise OverflowError(f"the exponent of {text!r} is too large")
    try:
        return Fraction(text)
    except ZeroDivisionError:
        raise ValueError(f"{text!r}: its denominator is 0") from None


def exact(x: Any) -> Fraction:
    """The number itself, whatever its type."""
    if isinstance(x, str):
        return _from_text(x)
    if isinstance(x, numbers.Rational):
        return Fraction(int(x.numerator), int(x.denominator))
    if hasattr(x, "__index__"):
        return Fraction(operator.index(x))
    ratio = getattr(x, "as_integer_ratio", None)
    if ratio is None:
        raise TypeError(f"a coefficient is no number that can be taken exactly: {x!r}")
    if abs(getattr(x, "adjusted", int)()) > DIGITS:  # a Decimal
        raise OverflowError(f"the exponent of {x!r} is too large")
    try:
        return Fraction(*ratio())
    except (OverflowError, ValueError):  # an infinity, a nan
        _algsurf.refuse(NOT_FINITE)
        raise


def floats(name: str, x: Any) -> NDArray[np.float64]:
    """Real numbers, each the nearest double, where C may read them."""
    try:
        a = np.asarray(x)
        if a.dtype.kind != "c":
            return np.require(a, np.float64, "A")
    except (TypeError, ValueError):
        pass
    raise TypeError(f"{name}: real numbers were expected")


def number(name: str, x: Any) -> float:
    try:
        return float(x)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: a number was expected, not {x!r}") from None


def whole(name: str, x: Any, least: int, most: int) -> int:
    refused = f"{name}: a whole number from {least} to {most} was expected, not {x!r}"
    try:
        n = operator.index(x)
    except TypeError:
        raise TypeError(refused) from None
    if not least <= n <= most:
        raise ValueError(refused)
    return n


def thread_count(threads: Any) -> int:
    """0: as many as there are processors."""
    return whole("threads", threads, 0, 256) or os.cpu_count() or 1


def is_double(x: Fraction) -> bool:
    try:
        return Fraction(float(x)) == x
    except OverflowError:
        return False


class Integers(NamedTuple):
    """Integers as the library takes them: limbs of all, and how many each has, with its sign."""

    limbs: NDArray[np.uint64]
    lengths: NDArray[np.intc]
    is_complex: bool


def _integers(fractions: Sequence[Fraction]) -> List[int]:
    """The same polynomial times a positive number."""
    common = 1
    for f in fractions:
        common *= f.denominator // math.gcd(common, f.denominator)
    whole = [f.numerator * (common // f.denominator) for f in fractions]
    divisor = 0
    for n in whole:
        divisor = math.gcd(divisor, n)
    return [n // divisor for n in whole] if divisor > 1 else whole


def plain(c: Sequence[Any]) -> Union[List[float], List[complex], Integers]:
    """The polynomial, or a positive multiple: floats or complex numbers if these are exact, else integers."""
    is_complex = any(isinstance(x, (complex, np.complexfloating)) for x in c)
    parts = [(x.real, x.imag) if isinstance(x, (complex, np.complexfloating)) else (x, 0) for x in c]
    re, im = [exact(x) for x, _ in parts], [exact(y) for _, y in parts]
    together = re + im if is_complex else re
    if not all(map(is_double, together)):
        together = [Fraction(n) for n in _integers(together)]
    if all(map(is_double, together)):
        doubles = [float(f) for f in together]
        n = len(re)
        return [complex(x, y) for x, y in zip(doubles[:n], doubles[n:])] if is_complex else doubles
    whole = [f.numerator for f in together]
    sizes = [(abs(n).bit_length() + 63) // 64 for n in whole]
    data = b"".join(abs(n).to_bytes(8 * size, "little") for n, size in zip(whole, sizes))
    limbs = np.frombuffer(data, "<u8").astype(np.uint64, copy=False)
    return Integers(limbs, np.array([-s if n < 0 else s for n, s in zip(whole, sizes)], np.intc), is_complex)


def _is_exact(a: NDArray[Any]) -> bool:
    """Do doubles hold all numbers of this array, by their type or by their size?"""
    if a.dtype.kind in "fc":
        return a.dtype.itemsize <= (8 if a.dtype.kind == "f" else 16)
    if a.dtype.kind in "iu" and a.dtype.itemsize == 8:
        return not a.size or (int(a.max()) <= WHOLE and int(a.min()) >= -WHOLE)
    return a.dtype.kind in "iub"


def polynomials(c: Any) -> Optional[Tuple[NDArray[Any], Tuple[int, ...]]]:
    """None: c is one polynomial.  Else an array of shape (m, n + 1), of doubles, of complex doubles, or of
    objects that have to be taken one by one, and the shape that answers have.  It is copied only if its type
    or its layout asks for it."""
    if isinstance(c, (list, tuple)) and c and isinstance(c[0], (list, tuple, np.ndarray)):
        if len({len(row) for row in c}) > 1:
            raise ValueError("polynomials of one call have the same number of coefficients")
        if len({getattr(row, "dtype", None) for row in c}) > 1 or not isinstance(c[0], np.ndarray):
            # numpy rounds whole numbers beside floats
            c = np.array(c, dtype=object)
            kinds = {type(x) for x in c.flat}
            if kinds <= {float, int, complex} and all(type(x) is not int or abs(x) <= WHOLE for x in c.flat):
                c = c.astype(complex if complex in kinds else float)
    elif not hasattr(c, "__array__") or hasattr(c, "coef") or np.ndim(c) < 2:
        return None
    c = np.asarray(c)
    if c.shape[-1] == 0:
        raise ValueError("a polynomial without coefficients")
    made: NDArray[Any] = c.reshape(-1, c.shape[-1])
    made = made.astype(object if not _is_exact(made) else complex if made.dtype.kind == "c" else float, copy=False)
    suits = made.flags.aligned and not any(step % 8 for step in made.strides)
    return made if suits else made.copy(), c.shape[:-1]


def one(c: Any) -> Sequence[Any]:
    """The coefficients of one polynomial, as a list."""
    if hasattr(c, "coef"):  # of numpy: the highest degree first, or another basis
        raise TypeError(f"coefficients, lowest degree first, were expected, not {type(c).__name__}")
    c = np.asarray(c) if hasattr(c, "__array__") else c
    if isinstance(c, (str, bytes, dict, set, frozenset)) or not hasattr(c, "__iter__") or getattr(c, "ndim", 1) != 1:
        raise TypeError(f"coefficients are a list or an array of numbers, not {c!r}")
    return list(c.tolist() if isinstance(c, np.ndarray) and c.dtype.kind in "fiubcO" else c)


def share(work: Callable[[int, int], Optional[Tuple[int, int]]], count: int, threads: int,
          degree: int = 6) -> List[Tuple[int, int]]:
    """Calls work(begin, end) for all of range(count), piece by piece, so that Ctrl-C is heard between them.
    Returns what was refused, if anything: (index, status), in increasing order."""
    threads = thread_count(threads)
    piece = max(1, min(16 + (1 << 22) // (degree + 1) ** 2, -(-count // threads)))
    begins = range(0, count, piece)
    ends = [min(begin + piece, count) for begin in begins]
    if threads == 1 or len(begins) <= 1:
        found = list(map(work, begins, ends))
    else:
        with ThreadPoolExecutor(min(threads, len(begins))) as pool:
            found = list(pool.map(work, begins, ends))
    return [(begin + at[0], at[1]) for begin, at in zip(begins, found) if at]


def refuse(status: int, before: str = "", after: str = "") -> None:
    """Raises what the status means, with words beside the library's."""
    try:
        _algsurf.refuse(status)
    except (ValueError, OverflowError, MemoryError) as error:
        raise type(error)(f"{before}{error}{after}") from None


def complain(what: str, refused: List[Tuple[int, int]], argument: str = "") -> None:
    """Raises for the first that is refused, with its number.  argument: what ALGSURF_E_ARGUMENT means there."""
    for index, status in refused:
        if argument and status == ARGUMENT:
            raise ValueError(f"{what} {index}: {argument}")
        refuse(status, f"{what} {index}: ")
