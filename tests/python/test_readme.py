"""What the README shows works as it stands."""

import re
from pathlib import Path

import numpy as np
import pytest
from conftest import cube_surface

meshio = pytest.importorskip("meshio")

README = Path(__file__).resolve().parents[2] / "README.md"


def test_python_examples(tmp_path, monkeypatch):
    cube = cube_surface()
    meshio.Mesh(0.2 * cube.points, [("triangle", cube.triangles)]).write(tmp_path / "bunny.stl")
    sliver = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0.05), (0, 1, 0.0)])
    meshio.Mesh(sliver, [("tetra", [(0, 1, 2, 3)])]).write(tmp_path / "old.msh", file_format="gmsh22")
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", README.read_text(), re.DOTALL)
    assert blocks
    for block in blocks:
        names = {}
        exec(compile(block, str(README), "exec"), names)
        assert names["mesh"].quality.min_dihedral_deg >= 30 and (tmp_path / "bunny.vtu").exists()
        assert np.allclose(names["rig"].positions(names["mesh"].points), names["surface"].points)
