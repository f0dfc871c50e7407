"""Tetrahedral meshes and triangle surfaces as numpy arrays."""

from __future__ import annotations

import dataclasses
import functools
import json
import os
from typing import TYPE_CHECKING, Any, Union

import numpy as np
import numpy.typing as npt

from . import _core

if TYPE_CHECKING:
    import meshio
    import pyvista

    from ._run import Verdict

Path = Union[str, "os.PathLike[str]"]
Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.signedinteger[Any]]

_REGION_NAMES = ("region", "gmsh:physical", "medit:ref", "tetgen:ref")


def _indices(array: npt.ArrayLike) -> Any:
    """As int32 where the values fit, else int64. What is no array of integers is left to the validation."""
    indices = np.asarray(array)
    if indices.dtype.kind not in "iu":
        return indices
    largest = np.iinfo(np.int32).max
    fits = indices.size == 0 or (indices.max() <= largest and indices.min() >= -largest)
    if fits and indices.dtype == np.uint32:
        return indices.view(np.int32)
    return indices.astype(np.int32 if fits else np.int64, copy=False)


def _optional(array: npt.ArrayLike | None, dtype: npt.DTypeLike) -> Any:
    return None if array is None else np.asarray(array).astype(dtype, casting="same_kind", copy=False)


@dataclasses.dataclass(frozen=True)
class Quality:
    """Shapes of tetrahedra, measured in floating point. Angles are dihedral, in degrees.

    tets_below_deg: how many have an angle below 5, 10, 15, 20, 30 degrees. histogram: of all angles, six a
    tetrahedron, in 36 bins of 5 degrees. worst: by smallest angle, as in JSON reports.
    """

    min_dihedral_deg: float
    max_dihedral_deg: float
    max_radius_edge: float
    volume: float
    inverted: int
    flat: int
    tets_below_deg: dict[int, int]
    tets_outside_30_135: int
    histogram: Integers = dataclasses.field(compare=False)
    worst: list[dict[str, Any]] = dataclasses.field(compare=False, repr=False)

    @classmethod
    def _of(cls, report: dict[str, Any]) -> Quality:
        ratio = report["max_radius_edge"]
        return cls(
            report["min_dihedral_deg"], report["max_dihedral_deg"], np.inf if ratio is None else ratio,
            report["volume"], report["inverted"], report["flat"],
            {int(degrees): count for degrees, count in report["tets_below_deg"].items()},
            report["tets_outside_30_135"], np.array(report["dihedral_histogram_5_deg"], dtype=np.int64),
            report["worst"])


class Mesh:
    """A tetrahedral mesh: n points, m tetrahedra.

    points: float64 (n, 3). tets: integers (m, 4), positively oriented in meshes of unsliver.
    regions: integers (m,), or None. faces: the triangles that the mesh lists, (k, 3); face_markers: integers
    (k,), or None. point_source: integers (n,), the index of each vertex in the points given, -1 for vertices
    of unsliver's; or None where no points were given. levels: of the lattice (n,), 0 for points given;
    frame: (unit, x, y, z) of the lattice; limits: (smallest angle, largest angle, radius-edge ratio) proven
    for all tetrahedra. The last three are None in meshes of others.
    report: the JSON report of the run that made the mesh (docs/JSON.md), or None.
    """

    def __init__(self, points: npt.ArrayLike, tets: npt.ArrayLike, *, regions: npt.ArrayLike | None = None,
                 faces: npt.ArrayLike | None = None, face_markers: npt.ArrayLike | None = None,
                 point_source: npt.ArrayLike | None = None, levels: npt.ArrayLike | None = None,
                 frame: tuple[float, float, float, float] | None = None,
                 limits: tuple[float, float, float] | None = None) -> None:
        """Raises InputError for arrays of the wrong shape, NaN, and indices out of range."""
        self._set(points, tets, regions=regions, faces=faces, face_markers=face_markers, point_source=point_source,
                  levels=levels, frame=frame, limits=limits)
        _core.validate_mesh(self)

    def _set(self, points: Any, tets: Any, *, regions: Any = None, faces: Any = None, face_markers: Any = None,
             point_source: Any = None, levels: Any = None, frame: Any = None, limits: Any = None) -> None:
        self.points: Floats = np.asarray(points)
        if self.points.dtype.kind in "iufb":
            self.points = self.points.astype(np.float64, copy=False)
        self.tets: Integers = _indices(tets)
        self.faces: Integers = _indices(np.empty((0, 3), np.int32) if faces is None else faces)
        self.regions: Integers | None = _optional(regions, np.int32)
        self.face_markers: Integers | None = _optional(face_markers, np.int32)
        self.point_source: Integers | None = _optional(point_source, np.int64)
        self.levels: npt.NDArray[np.uint8] | None = None if levels is None else np.asarray(levels, np.uint8)
        self.frame = frame
        self.limits = limits
        self.report: dict[str, Any] | None = None

    @classmethod
    def _of(cls, arrays: dict[str, Any], report: dict[str, Any] | None = None) -> Mesh:
        """Of arrays that the extension made, which need no validation."""
        mesh = cls.__new__(cls)
        mesh._set(**arrays)
        mesh.report = report
        return mesh

    def __repr__(self) -> str:
        status = "" if self.status in (None, "done") else f", {self.status}"
        return f"<unsliver.Mesh: {len(self.points):,} points, {len(self.tets):,} tetrahedra{status}>"

    @property
    def status(self) -> str | None:
        """How the run that made it ended: "done", or with `keep_partial` something else; None where unknown."""
        return None if self.report is None else self.report["status"]

    @functools.cached_property
    def quality(self) -> Quality:
        """Angles and ratios, measured when first asked for."""
        if self.report is not None and self.report.get("quality"):
            return Quality._of(self.report["quality"])
        return Quality._of(json.loads(_core.quality(self, 5)))

    @functools.cached_property
    def boundary_faces(self) -> Integers:
        """The triangles of exactly one tetrahedron, outward, (k, 3). In a box that was filled exactly, and in
        meshes from files that list triangles: `faces`, to which `face_markers` belong."""
        faces: Integers = self.faces if len(self.faces) else _indices(_core.boundary_faces(self))
        return faces

    def min_dihedral_angles(self) -> npt.NDArray[np.float32]:
        """Smallest dihedral angle of each tetrahedron, in degrees, (m,)."""
        return _core.min_dihedral_angles(self)

    def check(self, **options: Any) -> Verdict:
        """See `unsliver.check`."""
        from ._run import check

        return check(self, **options)

    def write(self, path: Path, *, format: str | None = None, ascii: bool = False) -> None:
        """See `unsliver.write`."""
        _core.write(os.fspath(path), self, format or "", ascii)

    def to_meshio(self) -> meshio.Mesh:
        """As a meshio.Mesh with the cell data "region" (tetrahedra and listed triangles) and the point data "level"
        and "point_source", as far as the mesh has them. Needs meshio."""
        meshio = _imported("meshio", "to_meshio")
        cells = [("tetra", self.tets)]
        regions = [np.zeros(len(self.tets), np.int32) if self.regions is None else self.regions]
        if len(self.faces):
            cells.append(("triangle", self.faces))
            regions.append(np.zeros(len(self.faces), np.int32) if self.face_markers is None else self.face_markers)
        labelled = self.regions is not None or self.face_markers is not None
        point_data = {"level": self.levels, "point_source": self.point_source}
        return meshio.Mesh(self.points, cells, cell_data={"region": regions} if labelled else {},
                           point_data={name: data for name, data in point_data.items() if data is not None})

    def to_pyvista(self) -> pyvista.UnstructuredGrid:
        """As a pyvista.UnstructuredGrid with the cell data "min_dihedral" and "region" and the point data
        "point_source", as far as the mesh has them. Needs pyvista."""
        pyvista = _imported("pyvista", "to_pyvista")
        grid = pyvista.UnstructuredGrid({pyvista.CellType.TETRA: self.tets}, self.points)
        grid.cell_data["min_dihedral"] = self.min_dihedral_angles()
        if self.regions is not None:
            grid.cell_data["region"] = self.regions
        if self.point_source is not None:
            grid.point_data["point_source"] = self.point_source
        return grid


class Surface:
    """A triangle surface, or soup: points float64 (n, 3), triangles integers (k, 3). It may be open or cross itself.
    `name` is what messages call it."""

    def __init__(self, points: npt.ArrayLike, triangles: npt.ArrayLike, *, name: str = "surface") -> None:
        """Raises InputError for arrays of the wrong shape, NaN, and indices out of range."""
        self.points: Floats = np.asarray(points)
        if self.points.dtype.kind in "iufb":
            self.points = self.points.astype(np.float64, copy=False)
        self.triangles: Integers = _indices(triangles)
        self.name = name
        _core.validate_surface(self)

    def __repr__(self) -> str:
        return f"<unsliver.Surface {self.name}: {len(self.points):,} points, {len(self.triangles):,} triangles>"


def from_meshio(mesh: meshio.Mesh) -> Mesh:
    """The tetrahedra of a meshio.Mesh, and its triangles as `faces`; other cells are left out. Labels are taken from the
    cell data "region", "gmsh:physical", "medit:ref" or "tetgen:ref"."""
    name = next((name for name in _REGION_NAMES if name in mesh.cell_data), None)

    def collected(kind: str, corners: int) -> tuple[Any, Any]:
        chosen = [i for i, block in enumerate(mesh.cells) if block.type == kind]
        if not chosen:
            return np.empty((0, corners), np.int64), None
        labels = None if name is None else np.concatenate([mesh.cell_data[name][i] for i in chosen])
        return np.concatenate([mesh.cells[i].data for i in chosen]), labels

    tets, regions = collected("tetra", 4)
    faces, face_markers = collected("triangle", 3)
    return Mesh(mesh.points, tets, regions=regions, faces=faces, face_markers=face_markers,
                point_source=mesh.point_data.get("point_source"))


def _imported(module: str, method: str) -> Any:
    try:
        return __import__(module)
    except ImportError as error:
        raise ImportError(f"Mesh.{method} needs {module}, which cannot be imported ({error}); "
                          f"`pip install {module}` gets it") from error
