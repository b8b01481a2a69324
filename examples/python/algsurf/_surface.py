"""Surfaces, rays and pictures: see the package."""
from __future__ import annotations

import functools
import math
import operator
import struct
import zlib
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _algsurf
from ._coefficients import ARGUMENT, complain, floats, number, refuse, share, thread_count, whole
from ._mesh import Mesh, made_mesh
from ._roots import Value

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Triple = Sequence[float]
    Size = Union[float, Triple]  # of an extent
    Colour = Union[str, Sequence[int]]
    Extent = Tuple[int, Tuple[float, ...], Tuple[float, ...]]

_TERM = np.dtype([("i", "i4"), ("j", "i4"), ("k", "i4"), ("a", "f8")], align=True)  # algsurf_term
_HIT = 1  # ALGSURF_STATE_HIT
_NAME = -10  # ALGSURF_E_NAME
_QUALITIES = ("preview", "standard", "full")


class Hits:
    """What rays meet first: arrays of the shape of the rays.

    found         whether the ray meets the surface: proved, as are t_lo, t_hi, multiplicity and side; the other
                  numbers are floats
    t             where on the ray, origin + t direction; infinity for a miss
    t_lo, t_hi    enclose the hit, and no hit is before t_lo
    multiplicity  the multiplicity of the root: odd where P changes its sign (1 at a plain crossing), even where it
                  does not (2 where the ray touches a smooth sheet); 0 for a ray in the surface, and for a miss
    side          the sign of P just before the hit; for a miss that along the ray, or 0 if it is not known; 0 for a
                  ray in the surface
    position, normal  shape (..., 3), the normal of unit length along the gradient of P; 0 for a miss, and the normal
                  can be 0 for a ray that lies in the surface
    """

    __slots__ = ("found", "t", "t_lo", "t_hi", "multiplicity", "side", "position", "normal")

    def __init__(self, shape: Tuple[int, ...], state: NDArray[np.uint8], t: NDArray[np.float64],
                 t_lo: NDArray[np.float64], t_hi: NDArray[np.float64], position: NDArray[np.float64],
                 normal: NDArray[np.float64], multiplicity: NDArray[np.intc], side: NDArray[np.int8]) -> None:
        self.found: NDArray[np.bool_] = (state == _HIT).reshape(shape)
        self.t = t.reshape(shape)
        self.t_lo, self.t_hi = t_lo.reshape(shape), t_hi.reshape(shape)
        self.multiplicity, self.side = multiplicity.reshape(shape), side.reshape(shape)
        self.position, self.normal = (np.moveaxis(a.reshape((3,) + shape), 0, -1) for a in (position, normal))

    def __repr__(self) -> str:
        if self.t.ndim == 0:
            return f"<a hit at t = {self.t.item()!r}>" if self.found else "<a miss>"
        return f"<{np.count_nonzero(self.found)} of {self.t.size} rays hit: shape {self.t.shape}>"


def _extent(size: Optional[Size], centre: Optional[Triple]) -> Optional[Extent]:
    """A ball for a number, a box for three, all of space for None."""
    if size is None:
        if centre is not None:
            raise ValueError("centre: of an extent; give extent, too")
        return None
    s = floats("extent", size)
    if s.shape not in ((), (3,)) or not ((s > 0) & (s < math.inf)).all():
        raise ValueError(f"extent: a radius above 0, or half the edges of a box, was expected, not {size!r}")
    c = (0.0,) * 3 if centre is None else tuple(_triple("centre", centre).tolist())
    return 1 + s.ndim, c, tuple(np.broadcast_to(s, 3).tolist())


def _common_shape(**shapes: Tuple[int, ...]) -> Tuple[int, ...]:
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        known = {name: str(shape) for name, shape in shapes.items() if shape}
        raise ValueError(f"{', '.join(known)}: shapes {' and '.join(known.values())} do not go together") from None


def _triple(name: str, x: Any) -> NDArray[np.float64]:
    a = floats(name, x)
    if a.shape != (3,) or not np.isfinite(a).all():
        raise ValueError(f"{name}: three numbers were expected, not {x!r}")
    return a


def _points(name: str, points: ArrayLike) -> NDArray[np.float64]:
    p = floats(name, points)
    if p.ndim == 0 or p.shape[-1] != 3:
        raise ValueError(f"{name}: an array of shape (..., 3) was expected, not {p.shape}")
    return p


def _colour(name: str, colour: Optional[Colour]) -> Sequence[float]:
    """Red, green, blue from 0 to 255."""
    if colour is None:
        return (math.nan,) * 3
    try:
        is_hex = isinstance(colour, str) and len(colour) == 7 and colour[0] == "#"
        rgb = list(bytes.fromhex(colour[1:])) if is_hex else [operator.index(x) for x in colour]  # type: ignore
    except (TypeError, ValueError):
        rgb = []
    if len(rgb) != 3 or not all(0 <= x <= 255 for x in rgb):
        raise ValueError(f'{name}: "#4aa3ff" or three numbers from 0 to 255 were expected, not {colour!r}')
    return rgb


class Surface:
    """All points at which a polynomial P(x, y, z) is 0.

    equation  as people write or paste it: Python, LaTeX, POV-Ray; "x^2 + y^2 = 1 - z^2".  Letters other than x, y, z
              are given their values by name: Surface("x^2 + y^2 = a z", a=1.2).  Named surfaces (`render --list`)
              are for the programs; here give their equation

    >>> ball = Surface("x^2 + y^2 + z^2 = r^2", r=2)
    >>> ball
    Surface('x^2 + y^2 + z^2 = r^2', r=2)
    >>> ball.degree, ball.terms["a"].tolist()
    (2, [1.0, 1.0, 1.0, -4.0])
    >>> Surface("x^2 + y^2 = b z")
    Traceback (most recent call last):
    ...
    ValueError: a name in the equation has no value: b (column 13)
    """

    def __init__(self, equation: str, /, **values: float) -> None:
        made = _made(equation, values)
        if isinstance(made, tuple):
            _refuse_values(values, made[0])
            _refuse_equation(equation, *made)
        for name in values:
            if not _is_used(equation, values, name, made):
                raise ValueError(f"{name}: not in the equation")
        self._handle = made
        self._equation: Optional[Tuple[str, Dict[str, float]]] = (equation, values)

    @classmethod
    def from_terms(cls, terms: Iterable[Tuple[int, int, int, float]]) -> Surface:
        """Of terms (i, j, k, a), each a x^i y^j z^k; `terms` of a surface among them.

        >>> Surface.from_terms([(2, 0, 0, 1), (0, 1, 0, -1)])  # x^2 = y
        Surface.from_terms([(0, 1, 0, -1.0), (2, 0, 0, 1.0)])
        """
        surface = cls.__new__(cls)
        try:
            all_terms = [(*map(operator.index, (i, j, k)), float(a)) for i, j, k, a in terms]
        except (TypeError, ValueError) as error:
            raise type(error)("terms: (i, j, k, a) each, three whole numbers and a number") from None
        if not all_terms:
            raise ValueError("no terms")
        if not all(0 <= e <= 64 for term in all_terms for e in term[:3]):
            raise ValueError("terms: exponents from 0 to 64")
        surface._handle, surface._equation = _algsurf.surface_from_terms(np.array(all_terms, _TERM)), None
        return surface

    def __reduce__(self) -> Tuple[Any, ...]:
        if self._equation is None:
            return type(self).from_terms, (self.terms.tolist(),)
        return functools.partial(type(self), **self._equation[1]), (self._equation[0],)

    def __repr__(self) -> str:
        if self._equation is None:
            return f"Surface.from_terms({self.terms.tolist()})"
        values = [f", {name}={value!r}" for name, value in self._equation[1].items()]
        return f"Surface({self._equation[0]!r}{''.join(values)})"

    @property
    def degree(self) -> int:
        """The total degree, at most 64."""
        return _algsurf.surface_about(self._handle)[0]

    @property
    def rounding(self) -> float:
        """How much coefficients differ from those of the equation, relatively: 0, or some 1e-16 for sqrt(5)."""
        return _algsurf.surface_about(self._handle)[1]

    @property
    def terms(self) -> NDArray[Any]:
        """A structured array of i, j, k, a: the terms a x^i y^j z^k."""
        return np.frombuffer(_algsurf.surface_about(self._handle)[2], _TERM)

    def value(self, points: ArrayLike) -> NDArray[np.float64]:
        """P at points of shape (..., 3): a float, without a bound: see value_and_bound.

        >>> Surface("x y = z").value([[1, 2, 3], [2, 2, 4]])
        array([-1.,  0.])
        """
        return self._at(points, 1, 1)[0]

    def value_and_bound(self, points: ArrayLike) -> Value:
        """P at points, and bounds: |value - exact value| <= bound."""
        return Value(*self._at(points, 1, 1))

    def _at(self, points: ArrayLike, *numbers: int) -> Sequence[NDArray[np.float64]]:
        """So many numbers of each point, in arrays."""
        p = np.ascontiguousarray(_points("points", points))
        flat, out = p.reshape(-1, 3), [np.empty((p.size // 3, n)) for n in numbers]
        complain("point", share(lambda a, b: _algsurf.surface_value(self._handle, flat[a:b], *(o[a:b] for o in out)),
                                len(flat), 1))
        return [o.reshape(p.shape[:-1] + (n,) * (n > 1)) for o, n in zip(out, numbers)]

    def gradient(self, points: ArrayLike) -> NDArray[np.float64]:
        """The gradient of P at points of shape (..., 3), in the same shape.

        >>> Surface("x y = z").gradient([1, 2, 3])
        array([ 2.,  1., -1.])
        """
        return self._at(points, 3)[0]

    def _trace(self, origins: ArrayLike, directions: ArrayLike, extent: Optional[Size], centre: Optional[Triple],
               t_min: ArrayLike, t_max: ArrayLike, threads: int, answers: Any) -> Tuple[Tuple[int, ...], Any]:
        """Asks for all rays; answers(n) allocates."""
        o, d = _points("origins", origins), _points("directions", directions)
        ends = [floats("t_min", t_min), floats("t_max", t_max)]
        shape = _common_shape(origins=o.shape[:-1], directions=d.shape[:-1], t_min=ends[0].shape, t_max=ends[1].shape)
        n, usual = math.prod(shape), not ends[0].any() and bool((ends[1] == math.inf).all())
        rows = o.flags.c_contiguous and d.flags.c_contiguous
        columns = o.ndim == 2 and o.flags.f_contiguous and d.flags.f_contiguous
        if usual and o.shape == d.shape and (rows or columns):
            o, d = o.reshape(-1, 3), d.reshape(-1, 3)
        else:  # in the layout that the library likes best
            o, d = (np.moveaxis(np.broadcast_to(a, shape + (3,)), -1, 0).reshape(3, n) for a in (o, d))
            o, d = np.ascontiguousarray(o).T, np.ascontiguousarray(d).T
        t = [np.ascontiguousarray(np.broadcast_to(t, shape)).reshape(-1) if not usual else np.empty(0) for t in ends]
        space, arrays = _extent(extent, centre), answers(n)
        complain("ray", share(lambda a, b: _algsurf.surface_rays(self._handle, space, a, b, o, d, *t, *arrays),
                              n, threads), "its direction is 0")
        return shape, arrays

    def first_hits(self, origins: ArrayLike, directions: ArrayLike, *, extent: Optional[Size] = None,
                   centre: Optional[Triple] = None, t_min: ArrayLike = 0, t_max: ArrayLike = math.inf,
                   threads: int = 1) -> Hits:
        """The first hit of each ray, origin + t direction, t_min <= t <= t_max: every ray is decided, proved.

        origins, directions  shape (..., 3), of one shape or broadcast to one; directions of any length
        extent   only what lies within counts: a number, the radius of a ball; three numbers, half the edges of a box;
                 None, all of space
        centre   of the ball or the box; None, 0
        t_min, t_max  numbers or arrays; a ray with t_min > t_max is a miss
        threads  0: as many as there are processors

        >>> torus = Surface("(x^2 + y^2 + z^2 + 3)^2 = 16 (x^2 + y^2)")
        >>> hits = torus.first_hits([[-4, 0, 0], [-4, 5, 0]], [1, 0, 0])
        >>> hits
        <1 of 2 rays hit: shape (2,)>
        >>> hits.t, hits.normal[0]
        (array([ 1., inf]), array([-1.,  0.,  0.]))
        """
        shape, arrays = self._trace(
            origins, directions, extent, centre, t_min, t_max, threads,
            lambda n: (np.empty(n, np.uint8), np.empty(n), np.empty(n), np.empty(n), np.empty((3, n)),
                       np.empty((3, n)), np.empty(n, np.intc), np.empty(n, np.int8)))
        return Hits(shape, *arrays)

    def occluded(self, origins: ArrayLike, directions: ArrayLike, *, extent: Optional[Size] = None,
                 centre: Optional[Triple] = None, t_min: ArrayLike = 0, t_max: ArrayLike = math.inf,
                 threads: int = 1) -> NDArray[np.bool_]:
        """Whether each ray meets the surface at all: proved, in less time than first_hits, which takes the same.

        >>> Surface("x^2 + y^2 + z^2 = 1").occluded([[3, 0, 0], [3, 2, 0]], [-1, 0, 0])
        array([ True, False])
        """
        shape, arrays = self._trace(origins, directions, extent, centre, t_min, t_max, threads,
                                    lambda n: (np.empty(n, np.uint8),))
        return np.asarray(arrays[0] == _HIT).reshape(shape)

    def enclose(self, extent: Size, centre: Optional[Triple] = None, *, singular: bool = False,
                precision: float = 1 / 16) -> Optional[Tuple[NDArray[np.float64], NDArray[np.float64]]]:
        """The corners of a box that holds all points of the surface within the extent; singular=True: only those
        points of it where the gradient is 0.  None if there are none: proved.  The search ends where no face can be
        pushed in by more than `precision` of the box's length.

        >>> low, high = Surface("x^2 + 4 y^2 + z^2 = 1").enclose(5)
        >>> bool((low <= [-1, -0.5, -1]).all() and (high < [1.1, 0.6, 1.1]).all())
        True
        >>> Surface("x^2 + y^2 + z^2 = -1").enclose(5) is None
        True
        """
        space = _extent(extent, centre)
        if space is None:
            raise ValueError("extent: a ball or a box, not all of space")
        if not 0 < number("precision", precision) <= 1:
            raise ValueError(f"precision: a number above 0, at most 1, was expected, not {precision!r}")
        box = _algsurf.surface_enclose(self._handle, space, int(singular), float(precision))
        return None if box is None else (np.array(box[:3]), np.array(box[3:]))

    def render(self, size: Tuple[int, int] = (640, 480), *, quality: str = "standard", eye: Optional[Triple] = None,
               look_at: Optional[Triple] = None, up: Optional[Triple] = None, fov: Optional[float] = None,
               orthographic: Optional[float] = None, zoom: float = 1, turn: Tuple[float, float] = (0, 0),
               extent: Optional[Size] = None, centre: Optional[Triple] = None, colour: Optional[Colour] = None,
               inside: Optional[Colour] = None, background: Optional[Colour] = None, antialias: int = 4,
               thin: bool = True, threads: int = 0) -> NDArray[np.uint8]:
        """A picture: an array of shape (height, width, 3), of bytes.  It is what the program render draws by the
        options of the same names; what is not given is chosen so that the surface fills the picture.

        size     width and height in pixels
        quality  "preview", "standard", or "full", which has shadows
        eye, look_at, up  where the camera stands, the point in the middle of the picture, what is up in it
        fov      the angle between bottom and top of the picture in degrees; or orthographic, its height in space
        zoom, turn  magnifies; moves the camera, degrees to the right and up
        extent, centre  what is shown: a ball or a box, as for first_hits
        colour, inside, background  "#4aa3ff" or three numbers from 0 to 255; inside is the side where P < 0
        antialias   n: edges have n x n samples a pixel, 1 to 16
        thin     draws lines and points that no ray meets: an aid to the eye, not proved
        threads  0: as many as there are processors

        >>> Surface("x^2 + y^2 = z^2").render((320, 240)).shape
        (240, 320, 3)
        """
        if quality not in _QUALITIES:
            raise ValueError(f"quality: one of {', '.join(_QUALITIES)}, not {quality!r}")
        if fov is not None and orthographic is not None:
            raise ValueError("orthographic: has no field of view; leave fov out")
        for name, x, most in (("fov", fov, 180.0), ("orthographic", orthographic, math.inf), ("zoom", zoom, 1e6)):
            if x is not None and not 0 < number(name, x) < most:
                raise ValueError(f"{name}: a number above 0 and below {most:g} was expected, not {x!r}")
        angles = floats("turn", turn)
        if angles.shape != (2,) or not np.isfinite(angles).all():
            raise ValueError(f"turn: two numbers were expected, not {turn!r}")
        if np.shape(size) != (2,):
            raise ValueError(f"size: width and height were expected, not {size!r}")
        width, height = (whole("size", x, 1, 65535) for x in size)
        whole("antialias", antialias, 1, 16)
        whole("threads", threads, 0, 256)
        look: List[float] = []
        for name, t in (("eye", eye), ("look_at", look_at), ("up", up)):
            look += [math.nan] * 3 if t is None else _triple(name, t).tolist()
        look += [math.nan if x is None else float(x) for x in (fov, orthographic, zoom, *angles)]
        for name, c in (("colour", colour), ("inside", inside), ("background", background)):
            look += _colour(name, c)
        look += [float(_QUALITIES.index(quality)), float(antialias), float(thin)]
        pixels = np.empty((height, width, 3), np.uint8)
        space = _extent(extent, centre)
        try:
            _algsurf.render(self._handle, space, np.array(look, np.float64), width, height, threads, pixels)
        except ValueError as error:
            same = eye is not None and (up is None if look_at is None else look[:3] == look[3:6])
            words = ("eye and look_at are the same point" if same else f"eye, look_at, up: {error}" if up is None
                     else "up: 0, or along the view")
            raise ValueError(words) from None
        return pixels

    def mesh(self, cells: int = 128, *, extent: Optional[Size] = None, centre: Optional[Triple] = None,
             solid: bool = False, on_surface: bool = False, threads: int = 0) -> Mesh:
        """Triangles of the surface, as the program mesh makes them (examples/guide/mesh.md): by all its crossings with
        the lines of a lattice.

        cells    of the lattice along the longest side of the extent, 4 to 2048
        extent, centre  what is meshed: a ball or a box, as for first_hits; None, as render chooses it. OverflowError
                 where sizes are not in 1e-30..1e30, or it is too far from the origin for doubles to show its cells
        solid    closes what is inside, P < 0, where the extent ends; else the surface is open there
        on_surface  vertices are on the surface; else triangles lie evenly on both sides of it, and volumes are right
        threads  0: as many as there are processors

        >>> ball = Surface("x^2 + y^2 + z^2 = 1").mesh(40)
        >>> ball
        <a mesh of 4196 triangles and 2100 points>
        >>> a, b, c = ball.points[ball.triangles].transpose(1, 0, 2)
        >>> round((np.cross(a, b) * c).sum() / 6, 4)  # its volume: 4/3 pi
        4.1888
        """
        space = _extent(extent, centre)
        whole("cells", cells, 4, 2048)
        return made_mesh(self._handle, space, cells, int(solid), int(on_surface), thread_count(threads))

    def _repr_png_(self) -> bytes:
        """What a notebook shows."""
        return png(self.render())


def _made(equation: str, values: Dict[str, float]) -> Any:
    return _algsurf.surface_from_equation(equation, tuple((name, number(name, v)) for name, v in values.items()))


def _is_used(equation: str, values: Dict[str, float], name: str, made: Any) -> bool:
    """Is a letter in the equation?  It is if without it, or with another value, there is another surface, or none."""
    others = {n: v for n, v in values.items() if n != name}
    for changed in (others, {**others, name: number(name, values[name]) + 1}):
        other = _made(equation, changed)
        if isinstance(other, tuple) or _algsurf.surface_about(other)[2] != _algsurf.surface_about(made)[2]:
            return True
    return False


def _refuse_values(values: Dict[str, float], status: int) -> None:
    """Raises if it is the name of a value that is refused."""
    for name in values if status == ARGUMENT else ():
        if name in ("x", "y", "z"):
            raise ValueError(f"{name} is a coordinate and takes no value")
        made = _made("x", {name: 1})
        if isinstance(made, tuple) and made[0] == ARGUMENT:
            raise ValueError(f"{name!r} takes no value: it is no letter or name, or that of a function")


def _refuse_equation(equation: str, status: int, offset: int, length: int, message: Optional[str]) -> None:
    data = equation.encode()
    before, word = (part.decode(errors="replace") for part in (data[:offset], data[offset : offset + length]))
    where = f"column {len(before) + 1}" + (f": {word!r}" if word and status != _NAME else "")
    refuse(status, after=f": {word if status == _NAME else message} ({where})" if message else "")


def png(pixels: NDArray[np.uint8]) -> bytes:
    """A picture of shape (height, width, 3), of bytes, as the bytes of a file."""
    if pixels.dtype != np.uint8 or pixels.ndim != 3 or pixels.shape[2] != 3:
        raise ValueError(f"pixels: bytes of shape (height, width, 3) were expected, not {pixels.dtype} {pixels.shape}")
    height, width = pixels.shape[:2]
    rows = np.zeros((height, 1 + 3 * width), np.uint8)  # a 0 before each row: no filter
    rows[:, 1:] = pixels.reshape(height, 3 * width)

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows.tobytes()))
            + chunk(b"IEND", b""))
