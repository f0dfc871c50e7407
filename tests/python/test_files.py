"""Files, meshio and pyvista."""

import os
import subprocess
import sys
import types

import numpy as np
import pytest
from conftest import cube_surface
from hypothesis import given
from hypothesis import strategies as st

import unsliver

meshio = pytest.importorskip("meshio")


def same(a, b, *names):
    for name in names:
        x, y = getattr(a, name), getattr(b, name)
        assert (x is None) == (y is None), name
        assert x is None or np.array_equal(x, y), name


def with_labels(simplices, labels):
    """In an order that does not depend on that of the file, which may group by label."""
    return sorted((*sorted(simplex), label) for simplex, label in zip(simplices.tolist(), labels.tolist()))


def labelled_mesh():
    mesh = unsliver.mesh(unsliver.box((0, 0, 0), (1, 1, 1), conform=True), size=0.4)
    mesh.regions = 1 + (mesh.points[mesh.tets].mean(axis=1)[:, 0] > 0.5).astype(np.int32)
    return mesh


@pytest.mark.parametrize("name, options", [
    ("a.vtu", {}), ("a.msh", {}), ("a.msh", {"format": "msh41"}), ("a.msh", {"ascii": True}), ("a.mesh", {}),
    ("a.node", {}),
])
def test_files_bring_back_what_was_written(tmp_path, name, options):
    mesh = labelled_mesh()
    unsliver.write(tmp_path / name, mesh, **options)
    back = unsliver.read(tmp_path / name)
    same(mesh, back, "points")
    assert with_labels(mesh.tets, mesh.regions) == with_labels(back.tets, back.regions)
    assert with_labels(mesh.faces, mesh.face_markers) == with_labels(back.faces, back.face_markers)


def test_vtu_keeps_the_lattice_and_the_guarantee(tmp_path, ball_mesh):
    ball_mesh.write(str(tmp_path / "ball.vtu"))
    back = unsliver.read(tmp_path / "ball.vtu")
    same(ball_mesh, back, "points", "tets", "levels")
    assert back.frame == ball_mesh.frame and back.limits == ball_mesh.limits and back.report is None
    assert unsliver.check(tmp_path / "ball.vtu").held_to["min_dihedral_deg"] == 30


def test_surfaces_and_points(tmp_path):
    cube = cube_surface()
    meshio.Mesh(cube.points, [("triangle", cube.triangles)]).write(tmp_path / "cube.stl")
    surface = unsliver.read(tmp_path / "cube.stl")
    assert len(surface.points) == 8 and len(surface.triangles) == 12
    by_name = unsliver.mesh(tmp_path / "cube.stl", size=0.4)
    assert np.array_equal(by_name.points, unsliver.mesh(surface, size=0.4).points)
    assert unsliver.check(by_name, against=tmp_path / "cube.stl")
    (tmp_path / "p.csv").write_text("x,y,z,size\n0,0,0,1\n1,0,0,2\n")
    points = unsliver.read_points(tmp_path / "p.csv")
    assert points.points.tolist() == [[0, 0, 0], [1, 0, 0]] and points.sizes.tolist() == [1, 2]


def test_meshio_round_trip():
    mesh = labelled_mesh()
    back = unsliver.from_meshio(mesh.to_meshio())
    same(mesh, back, "points", "tets", "regions", "faces", "face_markers")


def test_meshio_keeps_the_points_given():
    points = np.random.default_rng(7).random((20, 3))
    mesh = unsliver.mesh(points=points)
    same(mesh, unsliver.from_meshio(mesh.to_meshio()), "points", "tets", "point_source")


@pytest.mark.parametrize("name, file_format", [("a.vtu", "vtu"), ("a.msh", "gmsh"), ("a.msh", "gmsh22"),
                                               ("a.mesh", "medit")])
def test_meshio_and_we_read_each_other(tmp_path, name, file_format):
    mesh = labelled_mesh()
    mesh.write(tmp_path / name)
    theirs = unsliver.from_meshio(meshio.read(tmp_path / name))
    same(mesh, theirs, "points", "tets", "regions", "face_markers")
    plain = meshio.Mesh(mesh.points, [("tetra", mesh.tets)])
    plain.write(tmp_path / name, file_format=file_format)
    same(mesh, unsliver.read(tmp_path / name), "points", "tets")


def test_refine_and_check_take_meshio():
    sliver = meshio.Mesh(np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0.05), (0, 1, 0.0)]), [("tetra", [(0, 1, 2, 3)])])
    assert not unsliver.check(sliver, min_angle=30)
    assert unsliver.check(unsliver.refine(sliver), min_angle=30)


@given(count=st.integers(4, 12), seed=st.integers(0, 2**32 - 1))
def test_any_arrays_survive_a_file(tmp_path_factory, count, seed):
    random = np.random.default_rng(seed)
    tets = np.array([random.permutation(count)[:4] for _ in range(5)])
    mesh = unsliver.Mesh(random.normal(size=(count, 3)) * 10.0 ** random.integers(-20, 20), tets,
                         regions=random.integers(1, 100, 5))
    path = tmp_path_factory.mktemp("files") / "any.vtu"
    mesh.write(path)
    same(mesh, unsliver.read(path), "points", "tets", "regions")


def test_rigs_of_the_program_can_be_read(tmp_path):
    program = os.environ.get("UNSLIVER")
    if not program:
        pytest.skip("the program was not built")
    cube = cube_surface()
    (tmp_path / "cube.off").write_text("OFF\n8 12 0\n" + "\n".join(
        [" ".join(map(repr, p)) for p in cube.points.tolist()] + ["3 " + " ".join(map(str, t)) for t in cube.triangles]))
    mesh = unsliver.mesh(tmp_path / "cube.off", size=0.4)
    mesh.write(tmp_path / "cube.vtu")
    expected = unsliver.embed(cube.points, mesh)
    for name in ["rig.npz", "rig.vtu"]:
        subprocess.run([program, "embed", "cube.off", "cube.vtu", "-o", name], cwd=tmp_path, check=True)
    npz, vtu = np.load(tmp_path / "rig.npz"), meshio.read(tmp_path / "rig.vtu")
    assert np.array_equal(npz["points"], cube.points) and np.array_equal(npz["triangles"], cube.triangles)
    assert np.array_equal(vtu.points, cube.points) and np.array_equal(vtu.cells_dict["triangle"], cube.triangles)
    for name, array in expected._asdict().items():
        assert np.array_equal(npz[name], array) and np.array_equal(vtu.point_data[name], array), name


def test_pyvista_is_asked_for_clearly(monkeypatch, ball_mesh):
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(ImportError, match="to_pyvista needs pyvista.*pip install pyvista"):
        ball_mesh.to_pyvista()


def test_pyvista_gets_the_arrays(monkeypatch, ball_mesh):
    """A stand-in where pyvista is not installed: what its documentation says that the constructor takes."""
    try:
        import pyvista
    except ImportError:
        pyvista = types.ModuleType("pyvista")
        pyvista.CellType = types.SimpleNamespace(TETRA=10)
        pyvista.UnstructuredGrid = lambda cells, points: types.SimpleNamespace(
            cells_dict=cells, points=points, cell_data={}, point_data={})
        monkeypatch.setitem(sys.modules, "pyvista", pyvista)
    grid = ball_mesh.to_pyvista()
    assert np.array_equal(grid.points, ball_mesh.points)
    assert np.array_equal(grid.cells_dict[10], ball_mesh.tets)
    assert len(grid.cell_data["min_dihedral"]) == len(ball_mesh.tets)
