"""Bad input is an exception that names what is wrong, never a crash."""

import pickle

import numpy as np
import pytest
from conftest import cube_surface
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import unsliver

BALL = unsliver.ball((0, 0, 0), 1)
NAN = float("nan")


@pytest.mark.parametrize("options, word", [
    ({"size": -1}, "size is -1"), ({"size": NAN}, "size"), ({"size": "0.1+"}, "column 5"),
    ({"size": "x"}, "positive"), ({"size": {}}, "formula"), ({"edge_length": 0}, "edge_length"),
    ({"size": lambda p: p}, "shape"), ({"size": lambda p: -p[:, 0]}, "greater than 0"),
    ({"size_gradation": 0.1}, "size_gradation"), ({"min_angle": 31}, "30"), ({"max_radius_edge": 1}, "1.118"),
    ({"strategy": "best"}, "octree"), ({"strategy": "octree", "keep_partial": True}, "keep_partial"),
    ({"strategy": "closure", "points": [(0, 0, 0)]}, "points"), ({"size": 0.1, "size_max": 1}, "size_max"),
])
def test_bad_options(options, word):
    with pytest.raises(unsliver.Error) as caught:
        unsliver.mesh(BALL, **options)
    assert isinstance(caught.value, ValueError) and word in str(caught.value), str(caught.value)
    assert "--" not in str(caught.value)


@pytest.mark.parametrize("make", [
    lambda: unsliver.mesh(), lambda: unsliver.mesh(3), lambda: unsliver.mesh(points=[]),
    lambda: unsliver.mesh(BALL, points=[(0, 0)]), lambda: unsliver.mesh(BALL, points=["a"]),
    lambda: unsliver.mesh(BALL, points=[(0, 0, 0)], point_sizes=[1, 2]),
    lambda: unsliver.box((0, 0), (1, 1, 1)), lambda: unsliver.box((0, 0, 0), (1, 1, 0)),
    lambda: unsliver.ball((0, 0, 0), -1), lambda: unsliver.implicit("x^2 + 1", (0, 0, 0), (1, 1, 1)),
    lambda: unsliver.refine(unsliver.Mesh(np.eye(3), np.empty((0, 4), int))), lambda: unsliver.check(7),
    lambda: unsliver.mesh(unsliver.box((0, 0, 0), (1, 1, 1), conform=True), points=[(0, 0, 0)]),
    lambda: unsliver.mesh(unsliver.Mesh([(0, 0, 0)] * 4, [(0, 1, 2, 3)])),
])
def test_bad_arguments(make):
    with pytest.raises(unsliver.Error) as caught:
        make()
    assert isinstance(caught.value, ValueError) and "--" not in str(caught.value)


def test_ids_and_places():
    with pytest.raises(unsliver.InputError) as caught:
        unsliver.Mesh([(0, 0, 0), (1, NAN, 0)], [])
    assert caught.value.ids == [1]
    assert caught.value.places.shape == (1, 3) and np.isnan(caught.value.places[0, 1])
    with pytest.raises(unsliver.InputError) as caught:
        unsliver.Mesh(np.zeros((4, 3)), [(0, 1, 2, 3), (0, 1, 2, 4), (0, -1, 2, 3)])
    assert caught.value.ids == [1, 2] and caught.value.code == "bad_input"
    close = [(0, 0, 0), (1, 1, 1), (1, 1, 1 - 1e-15)]
    with pytest.raises(unsliver.InputError) as caught:
        unsliver.mesh(points=close)
    assert set(caught.value.ids) == {1, 2}


def test_arrays_changed_after_construction_are_checked_again():
    mesh = unsliver.Mesh(np.eye(4)[:, :3], [(0, 1, 2, 3)])
    mesh.tets[0, 0] = 1_000_000
    for use in [unsliver.check, unsliver.refine, lambda m: m.boundary_faces, lambda m: m.quality]:
        with pytest.raises(unsliver.InputError):
            use(mesh)


@given(tets=arrays.arrays(st.sampled_from([np.int8, np.int32, np.int64, np.uint64]), st.tuples(
    st.integers(0, 5), st.sampled_from([4, 4, 4, 3])), elements=None))
def test_any_indices_are_judged_or_refused(tets):
    points = np.random.default_rng(5).random((4, 3))
    try:
        verdict = unsliver.check(unsliver.Mesh(points, tets))
    except unsliver.InputError:
        assert tets.shape[1] != 4 or tets.size == 0 or tets.min() < 0 or tets.max() > 3
    else:
        assert isinstance(verdict.ok, bool)


def test_caps():
    with pytest.raises(unsliver.LimitError):
        unsliver.mesh(BALL, size=0.02, max_tets=1000)
    points = np.random.default_rng(6).random((200, 3))
    needed = len(unsliver.mesh(points=points).tets)
    with pytest.raises(unsliver.Stopped) as caught:
        unsliver.mesh(points=points, max_tets=needed // 2 + 1000)
    assert caught.value.status == "tet_cap" and caught.value.report["status"] == "tet_cap"
    partial = unsliver.mesh(points=points, max_tets=2000, keep_partial=True)
    assert partial.status == "tet_cap" and len(partial.tets) > 0 and "tet_cap" in repr(partial)


def test_files_that_are_not_there_or_not_what_they_say(tmp_path):
    with pytest.raises(OSError) as caught:
        unsliver.read(tmp_path / "none.vtu")
    assert isinstance(caught.value, unsliver.FileError) and "none.vtu" in str(caught.value)
    with pytest.raises(OSError):
        unsliver.mesh(str(tmp_path / "none.stl"))
    (tmp_path / "bad.off").write_text("OFF\n1 one\n")
    with pytest.raises(unsliver.FormatError):
        unsliver.read(tmp_path / "bad.off")
    with pytest.raises(unsliver.OptionError):
        unsliver.read(tmp_path / "points.doc")
    mesh = unsliver.Mesh(np.eye(4)[:, :3], [(0, 1, 2, 3)])
    with pytest.raises(unsliver.Error):
        mesh.write(tmp_path / "mesh.doc")
    with pytest.raises(unsliver.FileError):
        mesh.write(tmp_path / "missing" / "mesh.vtu")


def test_errors_can_be_pickled():
    with pytest.raises(unsliver.InputError) as caught:
        unsliver.Mesh([(0, 0, NAN)], [])
    copy = pickle.loads(pickle.dumps(caught.value))
    assert str(copy) == str(caught.value) and copy.ids == [0] and copy.places.shape == (1, 3)
    stopped = unsliver.Stopped("the end", "cancelled", {"status": "cancelled"})
    assert pickle.loads(pickle.dumps(stopped)).report == stopped.report


def test_a_surface_without_volume_is_refused():
    flat = unsliver.Surface(cube_surface().points * (1, 0, 0), cube_surface().triangles)
    with pytest.raises(unsliver.InputError):
        unsliver.mesh(flat)
