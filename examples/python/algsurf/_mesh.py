"""Triangles of a surface: see the package."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _algsurf

if TYPE_CHECKING:
    from numpy.typing import NDArray


class Mesh(NamedTuple):
    """Triangles: what Surface.mesh returns, and other packages take.

    points     shape (n, 3)
    triangles  shape (m, 3): numbers of points, anticlockwise as seen from where P > 0, or from outside a solid
    normals    shape (n, 3), of unit length, towards there; 0 where there is none
    crowded    edges of the lattice that the surface crosses more than once: with more cells there may be more to see
    touched    places where a line of the lattice touches the surface, as at sheets that no sign tells of
    undecided  places that stayed undecided
    sharp      cells in which the surface turns by more than 60 degrees: singular, or more cells are wanted
    """

    points: NDArray[np.float64]
    triangles: NDArray[np.uint32]
    normals: NDArray[np.float32]
    crowded: int
    touched: int
    undecided: int
    sharp: int

    def __repr__(self) -> str:
        return f"<a mesh of {len(self.triangles)} triangles and {len(self.points)} points>"


def made_mesh(*arguments: Any) -> Mesh:
    points, normals, triangles, *doubts = _algsurf.make_mesh(*arguments)
    return Mesh(np.frombuffer(points).reshape(-1, 3), np.frombuffer(triangles, np.uint32).reshape(-1, 3),
                np.frombuffer(normals, np.float32).reshape(-1, 3), *doubts)
