"""Meshing: domains, sizes, points, and what comes back."""

import numpy as np
import pytest
from conftest import cube_surface, radii_of_empty_balls, signed_volumes
from hypothesis import given
from hypothesis import strategies as st

import unsliver


def assert_is_good(mesh):
    assert mesh.status == "done" and mesh.report["verified"]
    assert mesh.quality.min_dihedral_deg >= 30 and mesh.quality.max_dihedral_deg <= 135
    assert signed_volumes(mesh).min() > 0
    assert unsliver.check(mesh)


def test_arrays(ball_mesh):
    mesh, n, m = ball_mesh, len(ball_mesh.points), len(ball_mesh.tets)
    assert_is_good(mesh)
    assert mesh.points.shape == (n, 3) and mesh.points.dtype == np.float64
    assert mesh.tets.shape == (m, 4) and mesh.tets.dtype == np.int32
    assert mesh.levels.shape == (n,) and len(mesh.frame) == 4
    assert mesh.limits == (30, 135, pytest.approx(5**0.5 / 2))
    assert mesh.report["mesh"] == {"vertices": n, "input_vertices": 0, "tets": m, "boundary_triangles": 0}
    assert signed_volumes(mesh).sum() == pytest.approx(mesh.quality.volume)
    assert mesh.min_dihedral_angles().min() == pytest.approx(mesh.quality.min_dihedral_deg)
    assert mesh.quality.histogram.sum() == 6 * m


def test_boundary_is_closed_and_outward(ball_mesh):
    a, b, c = (ball_mesh.points[ball_mesh.boundary_faces[:, k]] for k in range(3))
    enclosed = np.einsum("ij,ij->i", np.cross(a, b), c).sum() / 6
    assert enclosed == pytest.approx(ball_mesh.quality.volume)


def test_arrays_outlive_the_mesh():
    points = unsliver.mesh(unsliver.ball((0, 0, 0), 1), size=0.5).points
    copy = points.copy()
    unsliver.mesh(unsliver.ball((0, 0, 0), 1), size=0.4)
    assert (points == copy).all()


@pytest.mark.parametrize("domain", [
    unsliver.box((0, 0, 0), (1, 2, 1)), unsliver.ball((1, 2, 3), 1), cube_surface(),
    unsliver.implicit("x^2 + y^2 + z^2 - 1", (-2, -2, -2), (2, 2, 2)),
    unsliver.hull(np.random.default_rng(1).random((30, 3))),
], ids=["box", "ball", "surface", "implicit", "hull"])
def test_domains(domain):
    mesh = unsliver.mesh(domain, size=0.3)
    assert_is_good(mesh)
    assert mesh.report["input"]["domain"]


def test_a_domain_answers_questions():
    domain = unsliver.ball((0, 0, 0), 2)
    assert domain.kind == "ball" and np.allclose(domain.bounds, [(-2, -2, -2), (2, 2, 2)], rtol=1e-15)
    assert domain.volume == pytest.approx(4 / 3 * np.pi * 8)
    assert domain.contains([(0, 0, 0), (2, 2, 0), (0, 2, 0)]).tolist() == [True, False, True]
    open_cube = unsliver.Surface(cube_surface().points, cube_surface().triangles[1:])
    assert "boundary" in " ".join(unsliver.mesh(open_cube, size=0.4).report["input"]["notes"])


def test_a_box_is_filled_exactly():
    mesh = unsliver.mesh(unsliver.box((0, 0, 0), (2, 1, 1), conform=True), size=0.3)
    assert_is_good(mesh)
    assert signed_volumes(mesh).sum() == 2
    assert set(mesh.face_markers) == {1, 2, 3, 4, 5, 6}
    assert (mesh.points[mesh.boundary_faces[mesh.face_markers == 2], 0] == 2).all()
    with pytest.raises(unsliver.UnsupportedError) as caught:
        unsliver.mesh(unsliver.box((0, 0, 0), (1, 0.3, 0.1), conform=True), size=0.3)
    assert caught.value.places.shape == (2, 3)


SIZES = {
    "number": 0.25,
    "numpy": np.float32(0.25),
    "formula": "0.2 + 0.1 * x^2",
    "function": lambda p: 0.2 + 0.1 * p[:, 0] ** 2,
    "constant function": lambda p: 0.25,
    "list": [0.3, "0.25 + 0.1 * y^2", lambda p: 0.25 + abs(p[:, 2])],
}


@pytest.mark.parametrize("size", SIZES.values(), ids=SIZES)
def test_sizes_are_kept(size):
    mesh = unsliver.mesh(unsliver.ball((0, 0, 0), 1), size=size)
    assert_is_good(mesh)
    places = np.random.default_rng(2).uniform(-1, 1, (1000, 3))
    places = places[(places**2).sum(axis=1) <= 1]
    radii = radii_of_empty_balls(mesh, places)
    for part in size if isinstance(size, list) else [size]:
        if isinstance(part, str):
            part = eval("lambda p: " + part.replace("^", "**").replace("x", "p[:, 0]").replace("y", "p[:, 1]"))
        # The grid of a sampled function is fine enough for these.
        bound = part(places) if callable(part) else float(part)
        assert (radii <= 1.001 * np.asarray(bound)).all()


def test_a_function_is_called_once_with_all_points():
    calls = []

    def size(points):
        calls.append(points.shape)
        return np.full(len(points), 0.3)

    sizing = unsliver.sampled_size(size, (0, 0, 0), (1, 1, 1), samples=1000)
    assert len(calls) == 1 and calls[0][1] == 3 and calls[0][0] <= 1000
    assert sizing([(0.5, 0.5, 0.5)]) == pytest.approx(0.3)
    assert sizing.lipschitz == pytest.approx(0) and "sampled" in sizing.notes[0]


def test_sizes_on_a_background_mesh():
    corners = [(0, 0, 0), (3, 0, 0), (0, 3, 0), (0, 0, 3)]
    sizing = unsliver.nodal_size(unsliver.Mesh(corners, [(0, 1, 2, 3)]), [0.1, 0.4, 0.4, 0.4])
    assert sizing([(0, 0, 0), (1.5, 0, 0)]) == pytest.approx([0.1, 0.25])
    assert_is_good(unsliver.mesh(unsliver.box((0, 0, 0), (1, 1, 1)), size=sizing))


def test_gradation_and_edge_length():
    fine = unsliver.mesh(cube_surface(), size=0.1)
    graded = unsliver.mesh(cube_surface(), size=0.1, size_gradation=0.5, size_max=0.3)
    assert len(graded.tets) < len(fine.tets)
    edges = unsliver.mesh(cube_surface(), edge_length=0.2)
    assert edges.report["size"]["constant"] == pytest.approx(0.2 * edges.report["size"]["size_per_edge_length"])


@given(seed=st.integers(0, 2**32 - 1), count=st.integers(1, 60), duplicates=st.integers(0, 3))
def test_points_become_vertices(seed, count, duplicates):
    points = np.random.default_rng(seed).random((count, 3))
    points = np.concatenate([points, points[:duplicates]])
    mesh = unsliver.mesh(points=points)
    assert mesh.report["verified"]
    named = mesh.point_source >= 0
    assert (mesh.points[named] == points[mesh.point_source[named]]).all()
    assert named.sum() == count and named[:count].all()
    assert mesh.levels[named].max() == 0


def test_sizes_at_points():
    points = [(0.25, 0.5, 0.5), (0.75, 0.5, 0.5)]
    coarse = unsliver.mesh(unsliver.box((0, 0, 0), (1, 1, 1)), points=points, point_sizes=[0.2, 0.2])
    fine = unsliver.mesh(unsliver.box((0, 0, 0), (1, 1, 1)), points=points, point_sizes=[0.2, 0.02])
    assert len(fine.tets) > len(coarse.tets)


@given(seed=st.integers(0, 2**32 - 1))
def test_refine_keeps_vertices_and_removes_slivers(seed):
    points = np.random.default_rng(seed).random((5, 3)) * (1, 1, 0.05)
    bad = unsliver.Mesh(points, [(0, 1, 2, 3)])
    good = unsliver.refine(bad)
    assert_is_good(good)
    assert (good.points[:4] == points[:4]).all() and good.point_source[:4].tolist() == [0, 1, 2, 3]
    assert good.report["before"]["tets"] == 1


def test_looser_limits_take_fewer_vertices():
    points = np.random.default_rng(4).random((100, 3))
    strict = unsliver.mesh(points=points)
    loose = unsliver.mesh(points=points, min_angle=15, max_angle=150, max_radius_edge=1.5)
    assert len(loose.points) < len(strict.points)
    assert loose.quality.min_dihedral_deg >= 15 and loose.limits == (15, 150, 1.5)


def test_the_same_bytes_for_any_number_of_threads():
    def arrays(threads):
        mesh = unsliver.mesh(unsliver.ball((0, 0, 0), 1), size="0.1 + 0.05 * x^2", strategy="octree", threads=threads)
        return mesh.points.tobytes(), mesh.tets.tobytes()

    assert arrays(1) == arrays(3)


@given(seed=st.integers(0, 2**32 - 1))
def test_points_ride_on_the_mesh(seed):
    random = np.random.default_rng(seed)
    mesh = unsliver.mesh(unsliver.box((0, 0, 0), (1, 1, 1)), size=0.5)
    points = random.random((50, 3))
    rig = unsliver.embed(points, mesh)
    assert np.allclose(rig.positions(mesh.points), points, atol=1e-14) and rig.weights.min() >= 0
    assert (rig.vertices == mesh.tets[rig.tets]).all()
    turn, shift = random.normal(size=(3, 3)), random.normal(size=3)
    assert np.allclose(rig.positions(mesh.points @ turn + shift), points @ turn + shift, atol=1e-12)
    with pytest.raises(unsliver.InputError) as caught:
        unsliver.embed(np.concatenate([points, [(9, 9, 9)]]), mesh)
    assert caught.value.ids == [50]


def test_check_finds_faults(ball_mesh):
    torn = unsliver.Mesh(ball_mesh.points, np.delete(ball_mesh.tets, 100, axis=0), levels=ball_mesh.levels,
                         frame=ball_mesh.frame, limits=ball_mesh.limits)
    assert unsliver.check(torn, against=None)
    assert not unsliver.check(torn, against=cube_surface())
    inverted = unsliver.Mesh(ball_mesh.points, ball_mesh.tets[:, [1, 0, 2, 3]])
    verdict = unsliver.check(inverted)
    assert not verdict and verdict.finding_count == len(ball_mesh.tets)
    assert verdict.findings[0].check == "orientation" and verdict.findings[0].ids
    demanding = unsliver.check(ball_mesh, min_angle=61)
    assert not demanding and demanding.held_to["min_dihedral_deg"] == 61
    assert len(ball_mesh.check(worst=3).quality.worst) == 3
