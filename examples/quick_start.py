"""A ball with a size that varies: mesh it, look at its quality, write it for ParaView and read it back."""

import numpy as np

import unsliver

mesh = unsliver.mesh(unsliver.ball((0, 0, 0), 1), size=lambda p: 0.08 + 0.1 * np.abs(p[:, 2]))
print(mesh)
print(f"dihedral angles from {mesh.quality.min_dihedral_deg:.1f} to {mesh.quality.max_dihedral_deg:.1f} degrees")

mesh.write("quick_start_py.vtu")
verdict = unsliver.check("quick_start_py.vtu", min_angle=30, max_angle=135)
print(*verdict.checks, sep="\n")
assert verdict
