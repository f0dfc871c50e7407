"""Tetrahedral meshes with proven dihedral angles.

    import unsliver

    mesh = unsliver.mesh("part.stl", size=0.02)
    mesh.points, mesh.tets                  # numpy arrays
    mesh.quality.min_dihedral_deg           # 30 or more, proven and verified
    mesh.write("part.vtu")

Lengths are in the units of the coordinates, angles in degrees. Points are arrays of shape (n, 3). All functions may be
called from several threads at once; they release the interpreter lock while they work, and Ctrl-C ends them.
"""

from ._core import Domain, Progress, Sizing
from ._domains import ball, box, hull, implicit
from ._embed import Embedding, embed
from ._errors import (
    Error,
    FileError,
    FormatError,
    InputError,
    InternalError,
    LimitError,
    OptionError,
    Stopped,
    UnsupportedError,
)
from ._files import Points, read, read_points, write
from ._mesh import Mesh, Quality, Surface, from_meshio
from ._run import Finding, Verdict, check, mesh, refine
from ._sizes import nodal_size, sampled_size

__all__ = [
    "Domain", "Embedding", "Error", "FileError", "Finding", "FormatError", "InputError", "InternalError", "LimitError", "Mesh",
    "OptionError", "Points", "Progress", "Quality", "Sizing", "Stopped", "Surface", "UnsupportedError", "Verdict",
    "ball", "box", "check", "embed", "from_meshio", "hull", "implicit", "mesh", "nodal_size", "read", "read_points", "refine",
    "sampled_size", "write",
]
