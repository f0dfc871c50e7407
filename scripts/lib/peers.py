"""Programs of others that the benchmarks run beside unsliver."""

import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
CGAL_SOURCE, CGAL_BUILD = ROOT / "bench/peers", ROOT / "build/peers"
TIME_LIMIT = 600

CUBE_POINTS = [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)]
CUBE_TRIANGLES = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4),
                  (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]


def write_off(points, triangles, path):
    lines = ["OFF", f"{len(points)} {len(triangles)} 0"]
    lines += [" ".join(map(repr, point)) for point in points]
    lines += ["3 " + " ".join(map(str, triangle)) for triangle in triangles]
    path.write_text("\n".join(lines) + "\n")


def run(*command):
    """The output of a program; nothing where it fails or does not end."""
    try:
        return subprocess.run(command, check=True, timeout=TIME_LIMIT, stdout=subprocess.PIPE, text=True,
                              stderr=subprocess.DEVNULL).stdout
    except (OSError, subprocess.CalledProcessError, subprocess.TimeoutExpired):
        return None


def build_cgal_mesh():
    """The path of the program in bench/peers; nothing without CGAL."""
    configured = run("cmake", "-S", CGAL_SOURCE, "-B", CGAL_BUILD, "-DCMAKE_BUILD_TYPE=Release")
    if configured is None or run("cmake", "--build", CGAL_BUILD) is None:
        print("CGAL is left out: bench/peers does not build here")
        return None
    return CGAL_BUILD / "cgal_mesh"
