"""How fine."""

from __future__ import annotations

import numbers
from typing import Any, Callable, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import Domain, Sizing
from ._errors import InputError, OptionError
from ._mesh import Floats, Mesh

SizeFunction = Callable[[Floats], npt.ArrayLike]
Size = Union[float, str, Sizing, SizeFunction]


def sampled_size(f: SizeFunction, lo: npt.ArrayLike, hi: npt.ArrayLike, *, samples: int = 1_000_000) -> Sizing:
    """A function of points (n, 3) that gives sizes (n,), sampled in one call on a regular grid of about `samples` points
    in the box between two corners.

    Nothing can be proven about a function that can only be called. So the trilinear interpolant of the samples IS the
    size that the mesh keeps, proven and verified; detail between the samples is not seen. Outside of the box the size is
    that of its nearest point.
    """

    def values(points: Floats) -> Floats:
        result = np.asarray(f(points), dtype=np.float64)
        if result.ndim > 0 and result.shape != (len(points),):
            raise InputError(f"the size function gave an array of shape {result.shape} for {len(points)} points: "
                             "one size a point is needed")
        return np.broadcast_to(result, (len(points),))

    return _core.sampled_size(values, lo, hi, samples=samples)


def nodal_size(mesh: Mesh, values: npt.ArrayLike) -> Sizing:
    """Sizes at the points of a background mesh, interpolated linearly; outside, the size at the nearest point of its
    boundary."""
    return _core.nodal_size(mesh, values)


def as_request(size: Size | Sequence[Size] | None, edge_length: float | str | None,
               domain: Domain) -> dict[str, Any]:
    """Sizes as the extension takes them: the smallest constant as a text, and all the rest as functions."""
    given = [] if size is None else list(size) if isinstance(size, (list, tuple)) else [size]
    constants = [float(s) for s in given if isinstance(s, numbers.Real)]
    sizings = [_as_sizing(s, domain) for s in given if not isinstance(s, numbers.Real)]
    if isinstance(edge_length, numbers.Real):
        edge_length = repr(float(edge_length))
    return {"size": repr(min(constants)) if constants else None, "edge_length": edge_length, "sizings": sizings}


def _as_sizing(size: Any, domain: Domain) -> Sizing:
    lo, hi = domain.bounds
    if isinstance(size, Sizing):
        return size
    if isinstance(size, str):
        return _core.expression_size(size, lo, hi)
    if callable(size):
        return sampled_size(size, lo, hi)
    raise OptionError(f"size is {size!r}: a length, a formula, a function of points, an unsliver.Sizing or a list of "
                      "these is needed")
