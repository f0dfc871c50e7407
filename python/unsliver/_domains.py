"""Where to mesh."""

from __future__ import annotations

from typing import Any

import numpy.typing as npt

from . import _core
from ._core import Domain
from ._errors import OptionError
from ._files import read_surface
from ._mesh import Mesh, Surface


def box(lo: npt.ArrayLike, hi: npt.ArrayLike, *, conform: bool = False) -> Domain:
    """The box between two corners.

    conform: fill it exactly, with flat faces, `Mesh.face_markers` 1 to 6 (x low, x high, y low, ...). Its sides must be
    multiples of one short binary number; for a box that is not so, UnsupportedError.places are the corners of one near
    it.
    """
    return _core.box(lo, hi, conform=conform)


def ball(center: npt.ArrayLike, radius: float) -> Domain:
    """A ball."""
    return _core.ball(center, radius)


def implicit(expression: str, lo: npt.ArrayLike, hi: npt.ArrayLike) -> Domain:
    """Where a formula in x, y and z is <= 0, inside of the box between two corners."""
    return _core.implicit(expression, lo, hi)


def hull(points: npt.ArrayLike) -> Domain:
    """The convex hull of points. `mesh(hull(p), points=p)` makes the points vertices too."""
    return _core.domain_around_points(points, True)


def as_domain(domain: Any, points: npt.ArrayLike | None) -> Domain:
    """What `mesh` was asked for, as a Domain."""
    if domain is None and points is not None:
        return _core.domain_around_points(points, False)
    if isinstance(domain, Domain):
        return domain
    if isinstance(domain, Mesh):
        raise OptionError("this is a mesh already: unsliver.refine refines its slivers away, and "
                          "points=mesh.points takes its vertices alone")
    if isinstance(domain, Surface):
        return _core.domain_of_surface(domain)
    if hasattr(domain, "__fspath__") or isinstance(domain, str):
        return _core.domain_of_surface(read_surface(domain))
    raise OptionError(f"nothing to mesh: {domain!r} is no domain; give a surface (a file name or unsliver.Surface), "
                      "unsliver.box, ball, implicit or hull, or points")
