"""Roots of polynomials: what the package answers, and what it refuses."""
import copy
import math
import os
import pickle
import subprocess
import threading
import time
import unittest
from decimal import Decimal
from fractions import Fraction

import numpy as np

import algsurf
from algsurf import complex_roots, count_roots, evaluate, first_root, real_roots

PROGRAMS = os.environ.get("ALGSURF_PROGRAMS")
RANDOM = np.random.default_rng(1)
HUGE = 2**200 + 1


def same(case, a, b):
    """The same bits, nan among them."""
    case.assertEqual(a.dtype, b.dtype)
    case.assertEqual(a.shape, b.shape)
    case.assertEqual(a.tobytes(), b.tobytes())


class Numbers(unittest.TestCase):
    """Whatever the type of the coefficients, they are exact."""

    def test_types(self):
        self.assertEqual(real_roots(range(-2, 0)).value.tolist(), [-2])
        for c in ([-2, 0, 1], (-2.0, 0, 1), ["-2", "0", "1"], [Fraction(-2), 0, 1.0], [Decimal(-2), 0, 1],
                  np.array([-2, 0, 1]), np.array([-2.0, 0, 1]), np.array([-2, 0, 1], np.float32),
                  np.array([-2, 0, 1], np.int8), np.array([-2, 0, 1], ">f8"), np.array([-2, 0, 1], object),
                  np.array([-2, 9, 0, 9, 1])[::2], np.array([1.0, 0, -2])[::-1], np.array(["-2", "0", "1"]),
                  np.array([-2, 0, 1], np.longdouble), [np.int64(-2), np.float32(0), np.uint8(1)],
                  iter([-2, 0, 1])):
            self.assertEqual(real_roots(c).value.tolist(), [-math.sqrt(2), math.sqrt(2)], c)

    def test_exact_decimals_and_fractions(self):
        self.assertEqual(real_roots(["-0.6", "1.1", "-0.6", "0.1"]).value.tolist(), [1, 2, 3])
        r = real_roots([Fraction(-1, 147), Fraction(17, 147), Fraction(-13, 21), 1])  # (t - 1/3)(t - 1/7)^2
        self.assertEqual(r.multiplicity.tolist(), [2, 1])
        self.assertEqual(real_roots(["-1/3", "1"])[0].value, 1 / 3)
        self.assertEqual(real_roots([0.1, -1])[0].lo, 0.1)
        self.assertNotEqual(real_roots(["0.1", -1])[0].lo, real_roots(["0.1", -1])[0].hi)  # no double is the root
        self.assertEqual(real_roots([Decimal("1e-400"), -1])[0].hi, 5e-324)
        beyond = real_roots([10**400, 1])[0]
        self.assertEqual((beyond.value, beyond.lo), (-np.finfo(float).max, -math.inf))

    def test_integers_of_any_length(self):
        r = real_roots([-HUGE, 0, 1])
        self.assertEqual(len(r), 2)
        self.assertLess(abs(r.value[1] / 2.0**100 - 1), 1e-15)
        r = real_roots([HUGE * (HUGE + 1), -(2 * HUGE + 1), 1])  # roots HUGE and HUGE + 1, between the same doubles
        self.assertEqual(r.multiplicity.tolist(), [1, 1])
        self.assertEqual(r.value.tolist(), [2.0**200] * 2)
        self.assertEqual(count_roots([HUGE**2, -2 * HUGE, 1]), 1)
        self.assertEqual(complex_roots([HUGE**2, -2 * HUGE, 1]).multiplicity.tolist(), [2])
        self.assertEqual(complex_roots([1, 0, 2**60 + 1]).value.real.tolist(), [0, 0])
        # 2^53 + 1 is no double: with it rounded there would be a double root
        n = 2**53 + 1
        self.assertEqual(count_roots([n * (n - 1), 1 - 2 * n, 1]), 2)
        self.assertEqual(count_roots(np.array([[(2**31 + 1) * 2**31, -(2**32) - 1, 1]])).tolist(), [2])
        self.assertEqual(real_roots([0, 0, HUGE]).multiplicity.tolist(), [2])

    def test_complex_and_exact(self):
        r = complex_roots([1j, Fraction(1, 3)])
        self.assertEqual(r.value.tolist(), [-3j])
        r = complex_roots([complex(2.0**100, 1.0), HUGE])
        self.assertEqual(len(r), 1)
        with self.assertRaises(TypeError):
            real_roots([1j, 1])
        with self.assertRaises(TypeError):
            real_roots([1j, HUGE])

    def test_refused(self):
        for c, words in (([], "without coefficients"), ([0, 0], "identically zero"), ([math.nan, 1], "not finite"),
                         ([Fraction(1, 3), math.inf], "not finite"), (np.zeros(514), "degree above"),
                         ([1] * 514, "degree above"), (np.zeros((2, 0)), "without coefficients"),
                         (["x", 1], "Invalid literal"), (["1", "1/0"], "^'1/0': its denominator is 0"),
                         ([[1, 2], [1, 2, 3]], "the same number"), ([Fraction(1, 3)] * 514, "degree above"),
                         ([HUGE] * 514, "degree above")):
            for call in (real_roots, complex_roots, count_roots, first_root):
                with self.assertRaisesRegex((ValueError, TypeError), words):
                    call(c)
        for c in (5, None, "12", b"12", [None], [1, [2]], [b"1"], {1: 2}, {1, 2}, [[1, None]], np.poly1d([1, 0, -2]),
                  np.polynomial.Chebyshev([1, 2]), np.array(["2020-01-01"], "M8[D]"), np.float64(3)):
            for call in (real_roots, complex_roots, count_roots, first_root):
                with self.assertRaises(TypeError, msg=repr(c)):
                    call(c)
        for lo, hi, error in ((1, 0, ValueError), (math.nan, 1, ValueError), ("a", 1, TypeError),
                              (None, 1, TypeError)):
            for call in (real_roots, count_roots, first_root):
                for c in ([-2, 0, 1], ["-2", "0", "1/3"], [-HUGE, 1]):
                    with self.assertRaises(error):
                        call(c, lo, hi)
        for c, words in (([-2, 0, 1], "^lo is"), (["1/3", 1], "^lo is"), ([-HUGE, 1], "^lo is"),
                         ([[-2, 1]], "^polynomial 0: lo is"), ([["1/3", 1]], "^polynomial 0: lo is")):
            for call in (real_roots, count_roots, first_root):
                with self.assertRaisesRegex(ValueError, words + " above hi$"):
                    call(c, 1, 0)
        with self.assertRaises(OverflowError):
            real_roots(["1e999999999", 1])
        with self.assertRaises(OverflowError):
            real_roots([Decimal("1e999999"), 1])
        with self.assertRaises(ValueError):
            real_roots([2 ** (2**20 + 1), 1])  # more limbs than the library takes


    def test_kinds_of_errors(self):
        for status, kind, words in ((-1, ValueError, "out of its range"), (-3, MemoryError, "out of memory"),
                                    (-7, OverflowError, "overflow"), (-99, ValueError, "unknown status")):
            with self.assertRaisesRegex(kind, words):
                algsurf._algsurf.refuse(status)


class Answers(unittest.TestCase):
    def test_fields(self):
        r = real_roots([0, 0, 5, -6, 1])
        self.assertEqual([(x.value, x.lo, x.hi, x.multiplicity, x.sign) for x in r],
                         [(0, 0, 0, 2, 1), (1, 1, 1, 1, 1), (5, 5, 5, 1, -1)])
        self.assertEqual((len(r), r.count, r.shape), (3, 3, (3,)))
        self.assertEqual(r[-1].value, 5)
        self.assertEqual(r[r.value > 0]["value"].tolist(), [1, 5])
        self.assertEqual(r.array["multiplicity"].tolist(), [2, 1, 1])
        self.assertEqual(len(np.asarray(r)), 4)
        self.assertIn("0.0, 2 times", repr(r))
        self.assertEqual(repr(real_roots([1, 0, 1])), "<no real roots>")
        self.assertEqual(repr(real_roots([3])), "<no real roots>")
        self.assertIn("and 10 more", repr(real_roots(list(map(int, np.poly(np.arange(30).astype(object))[::-1])))))
        for other in (copy.deepcopy(r), pickle.loads(pickle.dumps(r))):
            self.assertEqual(repr(other), repr(r))
        r.value[0] = 7  # a user's own array
        self.assertEqual(r[0].value, 7)

    def test_complex_fields(self):
        r = complex_roots([-4, 0, 3, 0, 1])
        self.assertEqual(r.is_real.tolist(), [True, False, False, True])
        self.assertTrue((r.lo.real <= r.value.real).all() and (r.value.imag <= r.hi.imag).all())
        self.assertLess(abs(r.hi - r.lo).max(), 1e-15)
        self.assertEqual(np.poly(r).tolist(), [1, 0, 3, 0, -4])
        self.assertEqual(np.poly(complex_roots([-1, 3, -3, 1])).tolist(), [1, -3, 3, -1])
        self.assertEqual(complex_roots([5]).value.tolist(), [])

    def test_interval(self):
        self.assertEqual(real_roots([6, -5, 1], 2, 3).value.tolist(), [2, 3])
        self.assertEqual(real_roots([6, -5, 1], 2.5).value.tolist(), [3])
        self.assertEqual(count_roots([6, -5, 1], hi=2.5), 1)
        self.assertEqual(first_root([6, -5, 1]), 2)
        self.assertEqual(first_root([1, 0, 1]), math.inf)
        self.assertEqual(first_root(["1/3", 1]), -1 / 3)

    def test_evaluate(self):
        v = evaluate([-2, 0, 1], 1.5)
        self.assertIsInstance(v.value, float)
        self.assertEqual(v.value, 0.25)
        c = [Fraction(1, 3), Fraction(-7, 11), HUGE]
        for x in (0.5, -1e-30, 3e5):
            value, bound = evaluate(c, x)
            exactly = sum(a * Fraction(x) ** k for k, a in enumerate(c))
            self.assertLessEqual(abs(Fraction(value) - exactly), Fraction(bound))
            self.assertLess(bound, 1e-14 * abs(value))
        x = RANDOM.standard_normal((3, 4))
        self.assertEqual(evaluate([1, 1], x.T).value.tolist(), (x.T + 1).tolist())
        self.assertEqual(evaluate([1, 1], []).value.shape, (0,))
        self.assertEqual(evaluate([1e308, 1e308], 10).value, math.inf)
        with self.assertRaisesRegex(ValueError, "place 1: .*not finite"):
            evaluate([1, 1], [0, math.nan])
        for c in ([], [1] * 514):
            with self.assertRaises(ValueError):
                evaluate(c, 0)
        one = "^evaluate takes one polynomial$"
        for c, x, words in (([1j, 1], 0, "^evaluate: real coefficients only"), ([1, 1], 1j, "^x: real numbers"),
                            ([1, 1], "a", "^x: real numbers"), ([[1, 2], [1, 2]], 1, one), (np.ones((2, 2)), 1, one)):
            with self.assertRaisesRegex(TypeError, words):
                evaluate(c, x)

    @unittest.skipUnless(PROGRAMS, "no programs")
    def test_program(self):
        """The program roots has the same bits."""
        polys = ["-2 0 1", "1 0 1", "24 -50 35 -10 1", "4 -12 13 -6 1", "0 0 6 -5 1 0 0", "1e-300 0 -1e-300",
                 "-1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1", "-0.6 1.1 -0.6 0.1", "-1/147 17/147 -13/21 1",
                 "123456789012345678901234567890 1 -1e-20"]
        for poly in polys:
            c = poly.split()
            for call, option in ((real_roots, ["--real", "-inf:inf"]), (complex_roots, [])):
                lines = subprocess.run([PROGRAMS + "/roots", "--format", "tsv", *option], input=poly + "\n",
                                       text=True, stdout=subprocess.PIPE, check=True).stdout.splitlines()[1:]
                cells = [line.split("\t") for line in lines if "error" not in line]
                r = call(c)
                self.assertEqual([float(x[2]) for x in cells], r.value.real.tolist(), poly)
                self.assertEqual([int(x[8]) for x in cells], r.multiplicity.tolist(), poly)
                low = r.lo.real.tolist()
                self.assertEqual([float(x[4]) for x in cells], low, poly)


class Batches(unittest.TestCase):
    c = RANDOM.integers(-9, 10, (3000, 7)).astype(float)
    c[c[:, 6] == 0, 6] = 1

    def test_first_root_as_lists(self):
        """Catches: another way for arrays than for lists."""
        for row in self.c[:200]:
            self.assertEqual(first_root(row, -1, 1), first_root(row.tolist(), -1, 1))

    def test_as_single_calls(self):
        many, boxes = real_roots(self.c), complex_roots(self.c)
        counts, firsts = count_roots(self.c), first_root(self.c, -1, 1)
        for i in range(0, 3000, 7):
            one = real_roots(self.c[i])
            self.assertEqual(many.count[i], len(one))
            self.assertEqual(many.array[i, : len(one)].tobytes(), one.array.tobytes())
            self.assertTrue(np.isnan(many.value[i, len(one):]).all())
            one = complex_roots(self.c[i])
            self.assertEqual(boxes.array[i, : len(one)].tobytes(), one.array.tobytes())
            self.assertEqual(counts[i], count_roots(self.c[i]))
            self.assertEqual(firsts[i], first_root(self.c[i], -1, 1))

    def test_layouts_and_types(self):
        expected = real_roots(self.c, -2, 2).array
        wide = np.zeros((3000, 14))
        wide[:, ::2] = self.c
        readonly = self.c.copy()
        readonly.setflags(write=False)
        shifted = np.frombuffer(b"x" + self.c.tobytes(), np.uint8)[1:].view(np.float64).reshape(3000, 7)
        for c in (np.asfortranarray(self.c), wide[:, ::2], readonly, self.c.astype(np.float32),
                  self.c.astype(np.int16), self.c.astype(">f8"), self.c.tolist(), list(self.c), shifted,
                  self.c[::-1, ::-1][::-1, ::-1], [tuple(map(int, row)) for row in self.c],
                  self.c.astype(np.int64), self.c.astype(np.longdouble)):
            same(self, real_roots(c, -2, 2).array, expected)
        same(self, real_roots(self.c.reshape(3, 1000, 7), -2, 2).array.reshape(3000, 6), expected)
        boxes = complex_roots(self.c + 0j).value
        self.assertEqual(boxes.shape, (3000, 6))
        same(self, complex_roots(np.asfortranarray(self.c + 1j)).array, complex_roots(self.c + 1j).array)
        same(self, complex_roots((self.c + 1j).astype(np.complex64)).array, complex_roots(self.c + 1j).array)
        class Like:  # as other libraries' arrays
            def __array__(like, *_):
                return self.c

        same(self, real_roots(Like(), -2, 2).array, expected)
        self.assertEqual(complex_roots([[1j, 1], [1, 1]]).value.tolist(), [[-1j], [-1]])

    def test_rows_of_different_types(self):
        """No whole number is rounded to be beside another type."""
        big = 2**53 + 1
        for kind in (np.int64, np.uint64, object):
            for other in (np.float64, np.int64, np.float32):
                rows = [np.array([big, 1], kind), np.array([-4, 2], other)]
                for c in (rows, rows[::-1], [rows[0].tolist(), rows[1]]):
                    at = [len(row) and int(row[0]) == big for row in c].index(True)
                    self.assertEqual((real_roots(c).lo[at, 0], real_roots(c).hi[at, 0]), (-(2.0**53) - 2, -(2.0**53)))
                    self.assertEqual(count_roots(c, -(2.0**53), -(2.0**53)).tolist(), [0, 0])

    def test_intervals(self):
        lo = np.linspace(-3, 0, 3000)
        r = real_roots(self.c, lo, 1)
        f = first_root(self.c, lo, np.full(3000, 1.0))
        for i in range(0, 3000, 97):
            self.assertEqual(r.count[i], count_roots(self.c[i], lo[i], 1))
            self.assertEqual(math.isinf(f[i]), r.count[i] == 0)
        with self.assertRaisesRegex(ValueError, "^lo, hi: a number, or one for each polynomial"):
            real_roots(self.c, lo[:5], 1)
        with self.assertRaisesRegex(TypeError, "^hi: real numbers"):
            real_roots(self.c, lo, "a")
        with self.assertRaisesRegex(ValueError, "^polynomial 2999: lo is above hi"):
            first_root(self.c, lo, -1e-3)
        exact = real_roots([["-1/3", 1], [-HUGE, 1]], np.array([0.0, -1]), np.array([1.0, 1]))
        self.assertEqual(exact.count.tolist(), [1, 0])

    def test_threads(self):
        for threads in (0, 1, 2, 5):
            same(self, real_roots(self.c, threads=threads).array, real_roots(self.c).array)
            same(self, complex_roots(self.c, threads=threads).array, complex_roots(self.c).array)
            self.assertEqual(first_root(self.c, threads=threads).tolist(), first_root(self.c).tolist())
        for threads, error in ((-1, ValueError), (257, ValueError), (1.5, TypeError), ("a", TypeError)):
            for call in (real_roots, complex_roots, count_roots, first_root):
                for c in (self.c, [1, 1], ["1/3", 1]):
                    with self.assertRaisesRegex(error, "^threads: a whole number from 0 to 256"):
                        call(c, threads=threads)

    def test_refused(self):
        c = self.c.copy()
        c[2000, 3] = math.nan
        c[2500] = 0
        for call in (real_roots, complex_roots, first_root, count_roots):
            for threads in (1, 3):
                with self.assertRaisesRegex(ValueError, "polynomial 2000: a number is not finite"):
                    call(c, threads=threads)
        for call in (real_roots, complex_roots):
            r = call(c, strict=False)
            self.assertEqual(np.flatnonzero((r.multiplicity < 0).all(axis=1)).tolist(), [2000, 2500])
            self.assertTrue(np.isnan(r.value[2500]).all())
            good = np.arange(3000) % 500 != 0
            same(self, r.array[good], call(self.c).array[good])
        r = real_roots([["1/3", 1], [0, 0]], strict=False)
        self.assertEqual(r.multiplicity.tolist(), [[1], [-1]])
        with self.assertRaisesRegex(ValueError, "polynomial 1: polynomial is identically zero"):
            real_roots([["1/3", 1], [0, 0]])
        with self.assertRaisesRegex(ValueError, "degree above"):
            real_roots(np.ones((2, 514)))
        with self.assertRaisesRegex(ValueError, "degree above"):
            complex_roots(np.ones((2, 514)))
        with self.assertRaises(TypeError):
            real_roots(self.c + 1j)

    def test_small(self):
        self.assertEqual(real_roots(np.zeros((0, 7))).shape, (0, 6))
        self.assertEqual(complex_roots(np.zeros((0, 7)), threads=2).shape, (0, 6))
        self.assertEqual(first_root(np.zeros((0, 7))).shape, (0,))
        self.assertEqual(real_roots(np.ones((3, 1))).shape, (3, 0))
        self.assertEqual(complex_roots(np.ones((3, 1))).shape, (3, 0))
        self.assertEqual(count_roots(np.ones((3, 1))).tolist(), [0, 0, 0])
        self.assertEqual(repr(real_roots(np.ones((3, 2)))), "<real roots of polynomials: shape (3, 1), 3 roots>")
        leading = complex_roots(np.array([[1.0, 1, 0, 0]]))
        self.assertEqual(leading.multiplicity.tolist(), [[1, 0, 0]])

    def test_other_threads_run(self):
        """Catches: a call that holds Python's lock."""
        c = np.tile(np.poly(np.arange(1, 21))[::-1], (600, 1))
        done, ticks = threading.Event(), []

        def tick():
            while not done.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.001)

        other = threading.Thread(target=tick)
        other.start()
        begin = time.perf_counter()
        real_roots(c)
        end = time.perf_counter()
        done.set()
        other.join()
        during = [t for t in ticks if begin < t < end]
        self.assertGreater(end - begin, 0.03)
        self.assertGreater(len(during), (end - begin) * 100)


if __name__ == "__main__":
    unittest.main()
