"""Meshing, refining and judging."""

from __future__ import annotations

import json
import os
from typing import Any, Callable, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import Domain, Progress
from ._domains import as_domain
from ._errors import InternalError, OptionError, Stopped
from ._files import read, read_surface
from ._mesh import Mesh, Path, Quality, Surface, from_meshio
from ._sizes import Size, as_request


def mesh(domain: Domain | Surface | Path | None = None, *, points: npt.ArrayLike | None = None,
         point_sizes: npt.ArrayLike | None = None, size: Size | Sequence[Size] | None = None,
         edge_length: float | str | None = None, size_gradation: float | None = None, size_max: float | None = None,
         min_angle: float = 30, max_angle: float = 135, max_radius_edge: float | None = None, strategy: str = "auto",
         max_tets: int | None = None, max_memory: int | None = None, keep_partial: bool = False, verify: bool = True,
         threads: int | None = None, on_progress: Callable[[Progress], object] | None = None,
         cancelled: Callable[[], object] | None = None) -> Mesh:
    """A superset mesh of a domain: it covers the domain and reaches across its boundary by about one element; all its
    tetrahedra have dihedral angles in [30, 135] degrees. It is verified by an independent exact check.

    domain: a surface (the name of a .stl, .obj, .off or .ply file, or a Surface), or `box`, `ball`, `implicit`, `hull`.
    points: (n, 3), become vertices of the mesh, bit for bit: its first ones, in order, equal ones merged. Without a
        domain their bounding box is meshed.
    size: s, a ball radius: around each point p of the domain the closed ball of radius s(p) holds a vertex. A length; a
        formula in x, y, z; a function of points (n, 3) that gives (n,), sampled on a grid (see `sampled_size`); a
        `Sizing`; or a list of these: the smallest counts. By default the diagonal of the domain's bounds / 40, with
        points none.
    edge_length: the mean edge instead, a length or a formula.
    point_sizes: (n,), sizes at the points; they grow with the distance by size_gradation (0.3).
    size_gradation: g. A constant size grows away from a surface, or from points, as size + g * distance up to size_max;
        formulas and functions are lowered where they change faster.
    min_angle, max_angle, max_radius_edge: limits to keep; by default the strictest that are proven: 30, 135, and
        sqrt(5)/2 = 1.118, with points 1.368. Looser ones take fewer vertices.
    strategy: "auto", "literal", "thrifty", "octree" or "closure".
    max_tets, max_memory (bytes): caps; by default the memory available. A run that meets one raises Stopped, and one
        that surely would is not started: LimitError.
    keep_partial: where a cap or `cancelled` ends the run return the valid mesh so far; see `Mesh.status`.
    verify: False leaves the independent check out.
    threads: of strategy "octree", by default one for each core. The mesh is the same for every number.
    on_progress: called with a Progress a few times a second.
    cancelled: asked some fifty times a second; true ends the run. What callbacks raise ends the run and is raised here.
    """
    where = as_domain(domain, points)
    return _run("mesh", where, points=points, point_sizes=point_sizes, **as_request(size, edge_length, where),
                size_gradation=size_gradation, size_max=size_max, min_angle=min_angle, max_angle=max_angle,
                max_radius_edge=max_radius_edge, strategy=strategy, max_tets=max_tets, max_memory=max_memory,
                keep_partial=keep_partial, verify=verify, threads=threads, on_progress=on_progress,
                cancelled=cancelled)


def refine(mesh: Any, *, size: Size | Sequence[Size] | None = None, edge_length: float | str | None = None,
           size_gradation: float | None = None, size_max: float | None = None, min_angle: float = 30,
           max_angle: float = 135, max_radius_edge: float | None = None, strategy: str = "auto",
           max_tets: int | None = None, max_memory: int | None = None, keep_partial: bool = False, verify: bool = True,
           threads: int | None = None, on_progress: Callable[[Progress], object] | None = None,
           cancelled: Callable[[], object] | None = None) -> Mesh:
    """Refines the bad tetrahedra of a mesh away: a superset mesh of their union that has all its vertices, bit for bit.

    mesh: a Mesh, the name of a file, or a meshio.Mesh. The options are those of `mesh`.
    """
    where = _core.domain_of_tets(_as_mesh(mesh), mesh if isinstance(mesh, str) else "mesh")
    return _run("refine", where, points=None, point_sizes=None, **as_request(size, edge_length, where),
                size_gradation=size_gradation, size_max=size_max, min_angle=min_angle, max_angle=max_angle,
                max_radius_edge=max_radius_edge, strategy=strategy, max_tets=max_tets, max_memory=max_memory,
                keep_partial=keep_partial, verify=verify, threads=threads, on_progress=on_progress,
                cancelled=cancelled)


class Finding(NamedTuple):
    """A fault of a mesh. check: "orientation", "conformity", "dihedral", ..."""

    check: str
    message: str
    ids: list[int]


class Verdict:
    """What `check` found. True where there is no fault.

    ok, findings (the first of each kind), finding_count, checks (what was checked, a line each), quality; held_to: the
    limits it was judged by, or None; report: all of it, as in docs/JSON.md.
    """

    def __init__(self, report: dict[str, Any]) -> None:
        self.report = report
        verified = report["verify"]
        self.ok: bool = verified["ok"]
        self.findings = [Finding(f["check"], f["message"], f["ids"]) for f in verified["findings"]]
        self.finding_count: int = verified["finding_count"]
        self.checks: list[str] = verified["checks"]
        self.quality = Quality._of(report["quality"])
        self.held_to: dict[str, float | None] | None = report["held_to"]

    def __bool__(self) -> bool:
        return self.ok

    def __repr__(self) -> str:
        fault = "no fault" if self.ok else f"{self.finding_count} findings"
        return f"<unsliver.Verdict: {fault}, {len(self.checks)} checks>"


def check(mesh: Any, *, against: Surface | Path | None = None, min_angle: float | None = None,
          max_angle: float | None = None, max_radius_edge: float | None = None, worst: int = 5,
          on_progress: Callable[[Progress], object] | None = None,
          cancelled: Callable[[], object] | None = None) -> Verdict:
    """Judges any tetrahedral mesh, by exact arithmetic that shares nothing with the generator.

    mesh: a Mesh, the name of a file, or a meshio.Mesh. Orientation and conformity are always checked; in meshes of
        unsliver, which carry their lattice, all that they promise.
    against: a surface that must be covered.
    min_angle, max_angle, max_radius_edge: hold it to these.
    worst: how many of the worst tetrahedra to list.
    """
    surface = read_surface(against) if isinstance(against, (str, os.PathLike)) else against
    demands = _core.CheckDemands(min_angle, max_angle, max_radius_edge, worst)
    return Verdict(json.loads(_core.check(_as_mesh(mesh), surface, demands, on_progress, cancelled)))


def _run(command: str, domain: Domain, **keywords: Any) -> Mesh:
    arrays, text = _core.mesh(command, domain, keywords)
    report = json.loads(text)
    status = report["status"]
    if status == "verification_failed":
        first = report["verify"]["findings"][0]["message"]
        raise InternalError(f"the mesh failed its independent verification, which is a bug in unsliver: {first}. "
                            "verify=False returns it all the same")
    if status != "done" and not keywords["keep_partial"]:
        raise Stopped(_END[status] + "; keep_partial=True returns the mesh all the same", status, report)
    return Mesh._of(arrays, report)


_END = {
    "tet_cap": "the cap on tetrahedra ended the run",
    "memory_cap": "the cap on memory ended the run",
    "cancelled": "the run was cancelled",
    "unverified": "the run was cancelled during its verification",
}


def _as_mesh(mesh: Any) -> Mesh:
    if isinstance(mesh, (str, os.PathLike)):
        mesh = read(mesh)
    if isinstance(mesh, Mesh):
        return mesh
    if hasattr(mesh, "cells") and hasattr(mesh, "cell_data"):
        return from_meshio(mesh)
    raise OptionError(f"{mesh!r} is no tetrahedral mesh: give an unsliver.Mesh, the name of a file, or a meshio.Mesh")
