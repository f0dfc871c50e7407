"""A detailed surface that rides on a coarse mesh."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._mesh import Floats, Mesh


class Embedding(NamedTuple):
    """Where points lie in a mesh. tets: (n,), the tetrahedron of each; vertices: (n, 4), its corners; weights: (n, 4),
    barycentric coordinates, not negative, of sum 1."""

    tets: npt.NDArray[np.int64]
    vertices: npt.NDArray[np.int64]
    weights: Floats

    def positions(self, vertex_positions: npt.ArrayLike) -> Floats:
        """Where the points are, (n, 3), when the mesh's vertices are at these places, (vertices of the mesh, 3)."""
        corners = np.asarray(vertex_positions, dtype=np.float64)[self.vertices]
        positions: Floats = np.einsum("nk,nkd->nd", self.weights, corners)
        return positions


def embed(points: npt.ArrayLike, mesh: Mesh) -> Embedding:
    """The tetrahedra of a mesh that hold points, such as the vertices of the surface that it was made of. Raises
    InputError, with ids and places, where the mesh does not cover them."""
    return Embedding(*_core.embed(points, mesh))
