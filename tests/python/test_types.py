"""The type hints: complete, consistent, and of use to callers."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import unsliver

pytest.importorskip("mypy")

PACKAGE = Path(unsliver.__file__).parent
CONFIG = Path(__file__).resolve().parents[2] / "pyproject.toml"

CALLER = """
import numpy as np
import numpy.typing as npt
import unsliver

def f(points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    return 0.1 + points[:, 0] ** 2

def show(progress: unsliver.Progress) -> None:
    print(progress.phase, progress.tets)

mesh = unsliver.mesh(unsliver.ball((0, 0, 0), 1), size=[0.1, "x + 2", f], on_progress=show)
reveal_type(mesh)
reveal_type(mesh.quality.min_dihedral_deg)
unsliver.mesh("a.stl", size={1: 2})
unsliver.mesh("a.stl", 0.1)
unsliver.mesh("a.stl", sizes=0.1)
"""


def mypy(*arguments, folder):
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--config-file", CONFIG, "--cache-dir", folder,
                           *arguments], cwd=folder, capture_output=True, text=True, check=False)


def test_the_package_is_typed_strictly(tmp_path):
    result = mypy(PACKAGE, folder=tmp_path)
    assert result.returncode == 0, result.stdout + result.stderr
    assert (PACKAGE / "py.typed").exists()


def test_callers_are_told_of_their_mistakes(tmp_path, monkeypatch):
    (tmp_path / "caller.py").write_text(CALLER)
    monkeypatch.setenv("MYPYPATH", str(PACKAGE.parent))
    told = mypy("caller.py", folder=tmp_path).stdout
    assert 'Revealed type is "unsliver._mesh.Mesh"' in told and 'Revealed type is "builtins.float"' in told, told
    errors = [line.split(":")[1] for line in told.splitlines() if ": error:" in line]
    lines = CALLER.splitlines()
    wrong = {str(i + 1) for i, line in enumerate(lines) if "a.stl" in line}
    assert set(errors) == wrong, told


def test_the_stub_names_what_the_extension_has():
    stub = ast.parse((PACKAGE / "_core.pyi").read_text())
    named = {node.name for node in stub.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    assert named == {name for name in dir(unsliver._core) if not name.startswith("_")}
