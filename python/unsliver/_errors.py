"""What can go wrong. Every exception names the elements and places at fault where there are any."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
import numpy.typing as npt


class Error(Exception):
    """The base of all errors of unsliver.

    code: short name of the kind of error, as in JSON reports.
    ids: of the offending elements (points, triangles, tetrahedra: the message says which); may be empty.
    places: coordinates of the offending places, shape (k, 3); may be empty.
    """

    code = "error"

    def __init__(self, message: str, ids: Sequence[int] = (), places: npt.ArrayLike = ()) -> None:
        super().__init__(message)
        self.message = message
        self.ids = list(ids)
        self.places: npt.NDArray[np.float64] = np.asarray(places, dtype=np.float64).reshape(-1, 3)

    def __str__(self) -> str:
        return self.message

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.message, self.ids, self.places)


class OptionError(Error, ValueError):
    """An option is out of range, contradictory or without effect."""

    code = "bad_option"


class InputError(Error, ValueError):
    """The content of a file or array is unusable: NaN, empty, index out of range, ..."""

    code = "bad_input"


class FormatError(Error, ValueError):
    """A file does not have the syntax of its format."""

    code = "format"


class FileError(Error, OSError):
    """The operating system refused to read or write."""

    code = "io"


class UnsupportedError(Error):
    """Valid, but outside what this version does."""

    code = "unsupported"


class LimitError(Error):
    """The job would exceed a cap before it starts."""

    code = "limit"


class InternalError(Error, RuntimeError):
    """A bug in unsliver: please report it."""

    code = "internal"


class Stopped(Error):
    """A cap or a cancellation ended the run. `keep_partial=True` returns the unfinished mesh instead.

    status: "tet_cap", "memory_cap", "cancelled" or "unverified" (finished, cancelled during verification).
    report: what is known of the run, as in `Mesh.report`.
    """

    code = "stopped"

    def __init__(self, message: str, status: str, report: dict[str, Any]) -> None:
        super().__init__(message)
        self.status = status
        self.report = report

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.message, self.status, self.report)


# The extension raises the library's errors by their codes.
CLASSES = {
    error.code: error
    for error in (OptionError, InputError, FormatError, FileError, UnsupportedError, LimitError, InternalError)
}
