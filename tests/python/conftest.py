import numpy as np
import pytest
from hypothesis import settings

import unsliver

# Examples are drawn from a fixed seed, and take longer than hypothesis expects.
settings.register_profile("unsliver", deadline=None, max_examples=15, derandomize=True, print_blob=True)
settings.load_profile("unsliver")


def cube_surface(**options):
    """The unit cube's boundary, outward."""
    points = [(x, y, z) for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0)]
    triangles = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4),
                 (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    return unsliver.Surface(points, triangles, **options)


def radii_of_empty_balls(mesh, places):
    """Distance from each place to the nearest vertex, by brute force."""
    return np.sqrt(((places[:, None, :] - mesh.points[None, :, :]) ** 2).sum(axis=2).min(axis=1))


def signed_volumes(mesh):
    a, b, c, d = (mesh.points[mesh.tets[:, k]] for k in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6


@pytest.fixture(scope="session")
def ball_mesh():
    return unsliver.mesh(unsliver.ball((0, 0, 0), 1), size=0.25)
