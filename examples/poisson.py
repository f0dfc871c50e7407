"""Finite elements in numpy: -laplace(u) = f in a box that is filled exactly, u known on its faces; the error falls fourfold
where the elements' size is halved."""

import numpy as np

import unsliver


def exact(p):
    return np.sin(np.pi * p[:, 0]) * np.sin(np.pi * p[:, 1]) * np.sin(np.pi * p[:, 2])


def solve(mesh):
    """Linear elements: the root mean square of the error at the vertices."""
    corners = mesh.points[mesh.tets]
    edges = (corners[:, 1:] - corners[:, :1]).transpose(0, 2, 1)
    volumes = np.linalg.det(edges) / 6
    slopes = np.linalg.inv(edges)
    slopes = np.concatenate([-slopes.sum(axis=1, keepdims=True), slopes], axis=1)
    local = volumes[:, None, None] * (slopes @ slopes.transpose(0, 2, 1))

    n = len(mesh.points)
    stiffness = np.zeros((n, n))
    np.add.at(stiffness, (mesh.tets[:, :, None], mesh.tets[:, None, :]), local)
    load = np.zeros(n)
    source = 3 * np.pi**2 * exact(corners.mean(axis=1))
    np.add.at(load, mesh.tets, (volumes * source / 4)[:, None])

    u = exact(mesh.points)
    free = np.setdiff1d(np.arange(n), mesh.boundary_faces)
    fixed = np.setdiff1d(np.arange(n), free)
    solution = np.linalg.solve(stiffness[np.ix_(free, free)], load[free] - stiffness[np.ix_(free, fixed)] @ u[fixed])
    return np.sqrt(np.mean((solution - u[free]) ** 2))


cube = unsliver.box((0, 0, 0), (1, 1, 1), conform=True)
errors = [solve(unsliver.mesh(cube, size=size)) for size in (0.15, 0.075)]
print(f"errors {errors[0]:.2e} and {errors[1]:.2e}, ratio {errors[0] / errors[1]:.1f}")
assert errors[0] / errors[1] > 3
