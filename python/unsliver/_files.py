"""Files in and out."""

from __future__ import annotations

import os
from typing import NamedTuple

from . import _core
from ._errors import OptionError
from ._mesh import Floats, Mesh, Path, Surface


class Points(NamedTuple):
    """Points of a file, in its order. sizes: (n,), or None where the file has none. notes: what was skipped."""

    points: Floats
    sizes: Floats | None
    notes: list[str]


def read(path: Path) -> Mesh | Surface:
    """A tetrahedral mesh (.vtu .msh .mesh .node .ele) or a surface (.stl .obj .off .ply), by the extension."""
    name = os.fspath(path)
    if _core.is_surface_file(name):
        return read_surface(path)
    if _core.is_tet_mesh_file(name):
        return Mesh._of(_core.read_tet_mesh(name))
    raise OptionError(f"{name}: the extension is that of no mesh (.vtu .msh .mesh .node .ele) and no surface "
                      "(.stl .obj .off .ply); unsliver.read_points reads .xyz .csv .pqr")


def read_surface(path: Path) -> Surface:
    return Surface(**_core.read_surface(os.fspath(path)))


def read_points(path: Path) -> Points:
    """The points of a .xyz, .csv, .pqr or .node file, or the vertices of any surface or mesh file."""
    return Points(*_core.read_points(os.fspath(path)))


def write(path: Path, mesh: Mesh, *, format: str | None = None, ascii: bool = False) -> None:
    """By the extension: .vtu (ParaView), .msh (Gmsh), .mesh (MEDIT) or .node (TetGen); or by `format`: "vtu", "msh22",
    "msh41", "medit", "tetgen". ascii: .msh only, text instead of binary. The file appears whole or not at all."""
    mesh.write(path, format=format, ascii=ascii)
