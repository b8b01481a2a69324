"""Surfaces, rays and pictures: what the package answers, and what it refuses."""
import copy
import math
import os
import pickle
import signal
import struct
import subprocess
import tempfile
import threading
import time
import unittest
import zlib

import numpy as np

from algsurf import Surface, png

PROGRAMS = os.environ.get("ALGSURF_PROGRAMS")
TORUS = "(x^2 + y^2 + z^2 + 3)^2 = 16 (x^2 + y^2)"
RANDOM = np.random.default_rng(2)


class Surfaces(unittest.TestCase):
    def test_terms(self):
        s = Surface("x^2 + a y^3 = z", a=1.5)
        self.assertEqual(s.degree, 3)
        self.assertEqual(sorted(s.terms.tolist()), [(0, 0, 1, -1.0), (0, 3, 0, 1.5), (2, 0, 0, 1.0)])
        self.assertEqual(Surface.from_terms(s.terms).terms.tolist(), s.terms.tolist())
        self.assertEqual(repr(s), "Surface('x^2 + a y^3 = z', a=1.5)")
        for other in (pickle.loads(pickle.dumps(s)), copy.deepcopy(s)):
            self.assertEqual((other.terms.tolist(), repr(other)), (s.terms.tolist(), repr(s)))
        self.assertEqual(s.rounding, 0)
        s = Surface("sqrt(5) x = 1")
        self.assertTrue(0 < s.rounding < 1e-15)
        self.assertEqual(copy.deepcopy(s).rounding, s.rounding)
        self.assertEqual(copy.copy(Surface.from_terms(s.terms)).terms.tolist(), s.terms.tolist())
        self.assertEqual(Surface("φ x = 1", φ=2).terms["a"].tolist(), [2, -1])

    def test_values(self):
        s = Surface(TORUS)
        points = RANDOM.standard_normal((4, 5, 3))
        x, y, z = np.moveaxis(points, -1, 0)
        expected = (x**2 + y**2 + z**2 + 3) ** 2 - 16 * (x**2 + y**2)
        value, bound = s.value_and_bound(points)
        self.assertTrue((abs(value - expected) <= bound + 1e-12).all())
        self.assertLess(bound.max(), 1e-11)
        self.assertEqual(s.value(points).tolist(), value.tolist())
        self.assertEqual(s.value(points.astype(np.float32)[::2, 1:, ::-1]).shape, (2, 4))
        self.assertEqual(float(s.value([2, 0, 0])), 49 - 64)
        self.assertEqual(s.value(np.zeros((0, 3))).shape, (0,))
        step = 1e-6
        slope = (s.value(points + [step, 0, 0]) - s.value(points - [step, 0, 0])) / (2 * step)
        self.assertLess(abs(slope - s.gradient(points)[..., 0]).max(), 1e-4)
        with self.assertRaisesRegex(OverflowError, "point 1: overflow"):
            s.value([[0, 0, 0], [1e200, 0, 0]])
        with self.assertRaisesRegex(ValueError, "point 0: a number is not finite"):
            s.gradient([[math.nan, 0, 0]])
        for points in ([1, 2], 3, [[1, 2, 3, 4]]):
            with self.assertRaisesRegex(ValueError, "^points: an array of shape"):
                s.value(points)
        for points in ("abc", [1j, 0, 0], [[1], [1, 2]]):
            with self.assertRaisesRegex(TypeError, "^points: real numbers"):
                s.value(points)

    def test_refused(self):
        for equation, words in (("x^^2", "not a polynomial equation.*column 3: .\\^"), ("b x", "no value: b .column 1"),
                                ("x - x", "identically zero"), ("(x+y)^70", "degree above the limit"),
                                ("é + x", "column 1"), ("x\0", "null")):
            with self.assertRaisesRegex(ValueError, words):
                Surface(equation)
        with self.assertRaisesRegex(OverflowError, "overflow"):
            Surface("1e400 x")
        with self.assertRaisesRegex(ValueError, "not finite"):
            Surface("a x", a=math.nan)
        with self.assertRaisesRegex(TypeError, "^a: a number was expected, not 'q'"):
            Surface("a x", a="q")
        for values, words in (({"x": 2}, "^x is a coordinate and takes no value"),
                              ({"a b": 2}, "^'a b' takes no value"),
                              ({"a": 1, "": 2}, "^'' takes no value"), ({"sqrt": 2}, "^'sqrt' takes no value"),
                              ({"a": 1, "c": 2}, "^c: not in the equation")):
            with self.assertRaisesRegex(ValueError, words):
                Surface("a x^2 + y^2 = z", **values)
        for equation, values in (("e x = 1", {"e": math.e}), ("x + 0 c = 1", {"c": 2}), ("x^n = 1", {"n": 2}),
                                 ("a b x = 1", {"a": 0, "b": 1}), ("pi x = 1", {"pi": math.pi})):
            self.assertIsInstance(Surface(equation, **values), Surface)
        for arguments in ((1,), (None,), (b"x",), ()):
            with self.assertRaises(TypeError):
                Surface(*arguments)
        each, range_ = r"^terms: \(i, j, k, a\) each", "^terms: exponents from 0 to 64"
        for terms, kind, words in (([], ValueError, "^no terms"), ([(1, 0, 0, math.inf)], ValueError, "not finite"),
                                   ([(65, 0, 0, 1)], ValueError, range_), ([(-1, 0, 0, 1)], ValueError, range_),
                                   ([(2**70, 0, 0, 1)], ValueError, range_), ([(40, 40, 0, 1)], ValueError, "degree"),
                                   ([(2, 0, 0)], ValueError, each), ([(1.5, 0, 0, 1)], TypeError, each),
                                   (5, TypeError, each)):
            with self.assertRaisesRegex(kind, words):
                Surface.from_terms(terms)

    def test_enclose(self):
        low, high = Surface("(x-1)^2 + y^2 + z^2 = 1/4").enclose((5, 5, 5), centre=(1, 0, 0))
        self.assertTrue((low <= [0.5, -0.5, -0.5]).all() and (high >= [1.5, 0.5, 0.5]).all())
        self.assertLess((high - low).max(), 1.3)
        self.assertIsNone(Surface(TORUS).enclose(4, singular=True))
        low, high = Surface("x^2 + y^2 = z^2").enclose(4, singular=True, precision=0.5)
        self.assertTrue((low <= 0).all() and (high >= 0).all())
        for extent in (0, -1, math.inf, (1, 2), (1, 2, 0), None):
            with self.assertRaisesRegex(ValueError, "^extent: "):
                Surface(TORUS).enclose(extent)
        for precision in (0, 2, math.nan):
            with self.assertRaisesRegex(ValueError, "^precision: a number above 0, at most 1"):
                Surface(TORUS).enclose(1, precision=precision)
        with self.assertRaisesRegex(TypeError, "^precision: a number"):
            Surface(TORUS).enclose(1, precision="a")


class Rays(unittest.TestCase):
    s = Surface(TORUS)
    o = np.column_stack([np.full(5000, -5.0), RANDOM.uniform(-3, 3, (5000, 2))])
    d = np.column_stack([np.ones(5000), RANDOM.uniform(-0.2, 0.2, (5000, 2))])

    def test_hits(self):
        hits = self.s.first_hits(self.o, self.d)
        self.assertTrue(500 < np.count_nonzero(hits.found) < 4500)
        self.assertTrue((np.isinf(hits.t) == ~hits.found).all())
        t = hits.t[hits.found]
        self.assertTrue(((hits.t_lo[hits.found] <= t) & (t <= hits.t_hi[hits.found])).all())
        points = self.o[hits.found] + t[:, None] * self.d[hits.found]
        self.assertLess(abs(points - hits.position[hits.found]).max(), 1e-14)
        self.assertLess(abs(self.s.value(points)).max(), 1e-11)
        self.assertLess(abs(np.linalg.norm(hits.normal[hits.found], axis=1) - 1).max(), 1e-12)
        self.assertEqual(set(hits.multiplicity.tolist()), {0, 1})
        self.assertEqual(set(hits.side[hits.found].tolist()), {1})
        self.assertTrue((self.s.occluded(self.o, self.d) == hits.found).all())

    def test_layouts(self):
        def shifted(a):  # where doubles should not be
            return np.frombuffer(b"x" + a.tobytes(), np.uint8)[1:].view(np.float64).reshape(a.shape)

        self.assertEqual(self.s.value(shifted(self.o)).tolist(), self.s.value(self.o).tolist())
        expected = self.s.first_hits(self.o, self.d)
        f = np.asfortranarray
        for o, d, options in ((f(self.o), f(self.d), {}), (self.o, f(self.d), {}), (self.o.tolist(), self.d, {}),
                              (self.o.reshape(5, 1000, 3), self.d.reshape(5, 1000, 3), {}),
                              (self.o[::-1], self.d[::-1], {}), (shifted(self.o), self.d, {}),
                              (shifted(self.o), shifted(self.d), {"t_min": shifted(np.zeros(5000))}),
                              (self.o, self.d, {"threads": 2}), (f(self.o), f(self.d), {"threads": 0}),
                              (self.o, self.d, {"t_max": 1e6, "t_min": np.zeros(5000)}),
                              (self.o.astype(">f8"), np.column_stack([self.d, self.d])[:, :3], {"extent": 9}),
                              (self.o + 1, self.d, {"extent": (9, 9, 9), "centre": (1, 1, 1)})):
            s = self.s
            if "centre" in options:  # all of it moved
                s = Surface("((x-1)^2 + (y-1)^2 + (z-1)^2 + 3)^2 = 16 ((x-1)^2 + (y-1)^2)")
            hits = s.first_hits(o, d, **options)
            turn = slice(None, None, -1 if isinstance(o, np.ndarray) and o.strides[0] < 0 else 1)
            t, normal = hits.t.reshape(-1)[turn], hits.normal.reshape(-1, 3)[turn]
            self.assertTrue((np.isinf(t) == np.isinf(expected.t)).all())
            self.assertLess(np.nanmax(abs(np.where(np.isinf(t), 0, t) - np.where(np.isinf(t), 0, expected.t))), 1e-12)
            self.assertLess(abs(normal - expected.normal).max(), 1e-6)
            self.assertTrue((s.occluded(o, d, **options).reshape(-1)[turn] == expected.found).all())

    def test_broadcast_and_ends(self):
        hits = self.s.first_hits([-4, 0, 0], [[1, 0, 0], [0, 1, 0]])
        self.assertEqual(hits.t.tolist(), [1, math.inf])
        self.assertEqual(repr(hits), "<1 of 2 rays hit: shape (2,)>")
        one = self.s.first_hits((-4, 0, 0), (2, 0, 0))
        self.assertEqual((one.t.shape, float(one.t), one.position.tolist()), ((), 0.5, [-3, 0, 0]))
        self.assertEqual(repr(one), "<a hit at t = 0.5>")
        hits = self.s.first_hits([-4, 0, 0], [1, 0, 0], t_min=[0, 2, 4, 6], t_max=[[9], [4.5]])
        self.assertEqual(hits.t.tolist(), [[1, 3, 5, 7], [1, 3, math.inf, math.inf]])
        self.assertEqual(self.s.first_hits([-4, 0, 0], [1, 0, 0], t_min=-9, t_max=0).t, math.inf)
        self.assertEqual(self.s.first_hits(np.zeros((0, 3)), [1, 0, 0]).t.shape, (0,))
        wide = np.ones((5, 9))
        odd = self.s.first_hits(wide[::3, ::3][:1] * [-4, 0, 0], np.asfortranarray(wide)[::3, ::3][:1] * [1, 0, 0])
        self.assertEqual(odd.t.tolist(), [1])
        odd = self.s.first_hits(wide[::3, :3][1:2], wide[::2, 3:6][1:2])  # one ray, steps that differ
        self.assertEqual(odd.t.shape, (1,))
        touching = self.s.first_hits([-4, 0, 1], [1, 0, 0])
        self.assertEqual((float(touching.t), int(touching.multiplicity)), (2, 2))

    def test_in_the_surface(self):
        """A ray in it, and misses: what stands in the other arrays."""
        plane = Surface("z = 0")
        for hits, expected in ((plane.first_hits([0, 0, 0], [1, 0, 0]), (True, 0, 0)),
                               (plane.first_hits([0, 0, -1], [1, 0, 0]), (False, 0, -1)),
                               (plane.first_hits([0, 0, 2], [0, 0, -1], t_min=5, t_max=1), (False, 0, 0))):
            self.assertEqual((bool(hits.found), int(hits.multiplicity), int(hits.side)), expected)
        self.assertEqual(Surface("z^3 = 0").first_hits([0, 0, 1], [0, 0, -1]).multiplicity, 3)
        self.assertFalse(Surface("x y = 0").first_hits([0, 0, 0], [0, 0, 1]).normal.any())

    def test_refused(self):
        with self.assertRaisesRegex(ValueError, "^ray 1: its direction is 0"):
            self.s.first_hits([0, 0, 0], [[1, 0, 0], [0, 0, 0]])
        with self.assertRaisesRegex(ValueError, "^ray 1: its direction is 0"):
            self.s.occluded(np.zeros((2, 3)), np.array([[1.0, 0, 0], [0, 0, 0]]))
        d = self.d.copy()
        d[4000] = math.nan
        for threads in (1, 3):
            with self.assertRaisesRegex(ValueError, "ray 4000: a number is not finite"):
                self.s.first_hits(self.o, d, threads=threads)
            with self.assertRaisesRegex(ValueError, "ray 4000: a number is not finite"):
                self.s.occluded(self.o, d, threads=threads)
        for o, d, words in (([1, 2], [1, 2, 3], "^origins: an array"), (1, 2, "^origins: an array"),
                            (np.zeros((2, 3)), np.zeros((3, 3)),
                             r"^origins, directions: shapes \(2,\) and \(3,\) do not go together")):
            with self.assertRaisesRegex(ValueError, words):
                self.s.first_hits(o, d)
        for options, kind, words in (({"extent": -1}, ValueError, "^extent: "),
                                     ({"extent": "a"}, TypeError, "^extent: "),
                                     ({"centre": (1, 0, 0)}, ValueError, "^centre: of an extent; give extent, too"),
                                     ({"extent": 1, "centre": (1, 0)}, ValueError, "^centre: three numbers"),
                                     ({"t_min": [1, 2], "t_max": [1, 2, 3]}, ValueError, "^t_min, t_max: shapes"),
                                     ({"t_max": "a"}, TypeError, "^t_max: real numbers")):
            for call in (self.s.first_hits, self.s.occluded):
                with self.assertRaisesRegex(kind, words):
                    call([0, 0, 0], [1, 0, 0], **options)


class Pictures(unittest.TestCase):
    @unittest.skipUnless(PROGRAMS, "no programs")
    def test_program(self):
        """The pixels of the program render, which chooses the same view."""
        cases = ((TORUS, {}, []),
                 ("x^2 + y^2 = z^2", {"quality": "full", "antialias": 2, "eye": (5, 1, 2)},
                  ["--quality", "full", "--antialias", "2", "--eye", "5,1,2"]),
                 ("x^2 y^2 + y^2 z^2 + z^2 x^2 = x y z", {"extent": (1, 1, 0.5), "centre": (0, 0, 0.25)},
                  ["--extent", "box:1,1,0.5", "--centre", "0,0,0.25"]),
                 ("x^3 = y^2 + z^2", {"colour": "#4aa3ff", "inside": (255, 176, 58), "background": "#101820",
                                      "zoom": 1.5, "turn": (20, -10), "fov": 40},
                  ["--colour", "#4aa3ff", "--inside", "#ffb03a", "--background", "#101820", "--zoom", "1.5", "--turn",
                   "20,-10", "--fov", "40"]),
                 ("x^2 = y^2 z", {"orthographic": 5, "thin": False, "look_at": (0, 0, 1), "up": (1, 0, 0)},
                  ["--orthographic", "5", "--thin", "none", "--look-at", "0,0,1", "--up", "1,0,0"]))
        with tempfile.TemporaryDirectory() as folder:
            for equation, options, words in cases:
                subprocess.run([PROGRAMS + "/render", equation, "--size", "120x90", "--progress", "never", "--output",
                                folder + "/it.ppm", *words], check=True, stderr=subprocess.DEVNULL)
                with open(folder + "/it.ppm", "rb") as file:
                    pixels = file.read()[-120 * 90 * 3:]
                drawn = Surface(equation).render((120, 90), **options)
                self.assertTrue(len(set(pixels)) > 20)
                self.assertEqual(drawn.tobytes(), pixels, equation)

    def test_png(self):
        data = Surface(TORUS)._repr_png_()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", data[16:24]), (640, 480))
        at, kinds, packed = 8, [], b""
        while at < len(data):
            size, kind = struct.unpack(">I4s", data[at: at + 8])
            kinds.append(kind)
            packed += data[at + 8: at + 8 + size] if kind == b"IDAT" else b""
            self.assertEqual(struct.unpack(">I", data[at + 8 + size: at + 12 + size])[0],
                             zlib.crc32(data[at + 4: at + 8 + size]))
            at += 12 + size
        self.assertEqual(kinds, [b"IHDR", b"IDAT", b"IEND"])
        rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(480, 1921)
        self.assertTrue((rows[:, 1:].reshape(480, 640, 3) == Surface(TORUS).render(threads=1)).all())
        for pixels in (np.zeros((4, 4, 3)), np.zeros((4, 4), np.uint8), np.zeros((4, 4, 4), np.uint8)):
            with self.assertRaisesRegex(ValueError, "^pixels: bytes of shape"):
                png(pixels)

    def test_refused(self):
        s = Surface("x^2 + y^2 + z^2 = 1")
        for options in ({"size": (0, 9)}, {"size": (9, 65536)}, {"quality": "best"}, {"fov": 180}, {"fov": 0},
                        {"orthographic": -1}, {"fov": 20, "orthographic": 2}, {"zoom": 0}, {"turn": (math.nan, 0)},
                        {"eye": (1, 1, 1), "look_at": (1, 1, 1)}, {"eye": (1, 2)}, {"colour": "red"},
                        {"colour": (1, 2, 256)},
                        {"inside": "#12345g"}, {"antialias": 0}, {"antialias": 17}, {"threads": 257}, {"extent": 0},
                        {"centre": (1, 0, 0)}, {"eye": (math.inf, 0, 0)}, {"size": (1, 2, 3)}):
            with self.assertRaises(ValueError, msg=str(options)):
                s.render(**{"size": (8, 8), **options})
        same, up = "^eye and look_at are the same point", "^up: 0, or along the view"
        for options, kind, words in (
                ({"size": 640}, ValueError, "^size: width and"),
                ({"size": (32, 24, 3)}, ValueError, "^size: width and"),
                ({"size": (8.5, 8)}, TypeError, "^size: a whole number from 1 to 65535"),
                ({"antialias": 17}, ValueError, "^antialias: a whole number from 1 to 16 was expected, not 17$"),
                ({"antialias": 1.5}, TypeError, "^antialias: "), ({"threads": "a"}, TypeError, "^threads: "),
                ({"threads": 257}, ValueError, "^threads: a whole number from 0 to 256 was expected, not 257$"),
                ({"colour": 5}, ValueError, "^colour: "), ({"colour": "#zzzzzz"}, ValueError, '^colour: "#4aa3ff" or'),
                ({"inside": (1, 2, "a")}, ValueError, "^inside: "), ({"turn": 5}, ValueError, "^turn: two numbers"),
                ({"turn": "ab"}, TypeError, "^turn: "), ({"zoom": "a"}, TypeError, "^zoom: a number"),
                ({"eye": "abc"}, TypeError, "^eye: "), ({"centre": (1, 0, 0)}, ValueError, "^centre: of an extent"),
                ({"eye": (1, 1, 1), "look_at": (1, 1, 1)}, ValueError, same), ({"eye": (0, 0, 0)}, ValueError, same),
                ({"eye": (1, 1, 1), "look_at": (1, 1, 1), "up": (0, 0, 1)}, ValueError, same),
                ({"eye": (0, 0, 5), "look_at": (0, 0, 0), "up": (0, 0, 1)}, ValueError, up),
                ({"up": (0, 0, 0)}, ValueError, up)):
            with self.assertRaisesRegex(kind, words, msg=str(options)):
                s.render(**{"size": (8, 8), **options})
        self.assertTrue((Surface("1 = 0").render((8, 8)) == 255).all())

    def test_interrupt(self):
        """Ctrl-C ends a picture."""
        s = Surface(" + ".join(f"cos({i}) {v}^{i}" for v in "xyz" for i in range(3, 21)) + " = 1")
        self.addCleanup(signal.signal, signal.SIGINT, signal.getsignal(signal.SIGINT))
        signal.signal(signal.SIGINT, signal.default_int_handler)  # shells let background jobs ignore it
        timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
        begin = time.perf_counter()
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            s.render((4000, 3000), quality="full", antialias=16, extent=1, eye=(3, 2, 1), look_at=(0, 0, 0))
        self.assertLess(time.perf_counter() - begin, 15)


def volume(m):
    a, b, c = m.points[m.triangles].transpose(1, 0, 2)
    return (np.cross(a, b) * c).sum() / 6


class Meshes(unittest.TestCase):
    def test_closed(self):
        m = Surface(TORUS).mesh(64)
        edges = np.concatenate([m.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
        self.assertEqual(len(np.unique(edges, axis=0)), len(edges))  # once in each direction
        self.assertTrue((np.sort(edges[:, ::-1], axis=0) == np.sort(edges, axis=0)).all())
        self.assertEqual(len(m.points) - len(edges) // 2 + len(m.triangles), 0)
        self.assertAlmostEqual(volume(m), 4 * math.pi**2, delta=1e-3)  # radii 2 and 1
        self.assertTrue(np.allclose(np.linalg.norm(m.normals, axis=1), 1, atol=1e-6))
        self.assertEqual((m.touched, m.undecided, m.sharp), (0, 0, 0))
        again = Surface(TORUS).mesh(64, threads=3)
        self.assertTrue((m.points == again.points).all() and (m.triangles == again.triangles).all())

    def test_extent(self):
        s = Surface("z = 0")
        m = s.mesh(20, extent=(1, 2, 3), centre=(5, 0, 0), on_surface=True)
        self.assertTrue((m.points[:, 2] == 0).all())
        self.assertLess(abs(m.points[:, :2].min(axis=0) - [4, -2]).max(), 1e-6)
        self.assertAlmostEqual(volume(s.mesh(20, extent=(1, 1, 1), solid=True)), 4, delta=1e-6)
        self.assertEqual(len(Surface("1 = 0").mesh(8).triangles), 0)

    def test_as_the_program(self):
        if not PROGRAMS:
            self.skipTest("no programs")
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([f"{PROGRAMS}/mesh", TORUS, "--cells", "40", "--output", f"{folder}/a.obj"], check=True,
                           stderr=subprocess.DEVNULL)
            with open(f"{folder}/a.obj", encoding="utf-8") as file:
                lines = [line.split() for line in file]
        m = Surface(TORUS).mesh(40)
        points = np.array([line[1:4] for line in lines if line and line[0] == "v"], float)
        self.assertTrue(np.allclose(points, m.points, atol=1e-6))
        self.assertEqual(len([line for line in lines if line and line[0] == "f"]), len(m.triangles))

    def test_refused(self):
        s = Surface("x = 0")
        for options in ({"cells": 3}, {"cells": 2049}, {"extent": 0}, {"extent": (1, 2)}, {"threads": 257}):
            with self.assertRaises(ValueError, msg=str(options)):
                s.mesh(**options)
        for options, kind, words in (
                ({"cells": 8.5}, TypeError, "^cells: a whole number from 4 to 2048 was expected, not 8.5$"),
                ({"threads": "a"}, TypeError, "^threads: "), ({"cells": 3}, ValueError, "^cells: [^;]*$"),
                ({"extent": 1e155}, OverflowError, "."), ({"extent": 1, "centre": (1e15, 0, 0)}, OverflowError, "."),
                ({"centre": (1, 0, 0)}, ValueError, "^centre: of an extent; give extent, too")):
            with self.assertRaisesRegex(kind, words):
                s.mesh(**options)


if __name__ == "__main__":
    unittest.main()
