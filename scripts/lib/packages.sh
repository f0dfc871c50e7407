# Debian packages that the scripts need, and how they get them. Sourced, not run.

# To build the program and the library.
packages_build=(cmake ninja-build g++ libboost-dev libfmt-dev libcli11-dev nlohmann-json3-dev libdeflate-dev
                pkg-config)
# To build and install the Python package.
packages_python=(python3-dev pybind11-dev python3-numpy python3-venv python3-pip python3-setuptools python3-wheel)
# To run the tests: a second compiler, the checkers, the test libraries, the oracle.
packages_test=(clang clang-format clang-tidy libclang-rt-14-dev python3
               libgtest-dev libbenchmark-dev libcgal-dev
               "${packages_python[@]}" python3-pytest python3-hypothesis python3-meshio mypy)
# The other mesh generators that the long tier measures against.
packages_peers=(tetgen gmsh)
# Faster rebuilds. Installed along with missing packages, never asked for alone.
packages_welcome=(ccache)

# missing_packages NAME...: those that are not installed, one a line.
missing_packages() {
  local name
  for name in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || echo "$name"
  done
}

# as_root COMMAND...: runs it as root or through sudo; fails where neither is possible.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
    sudo --preserve-env=DEBIAN_FRONTEND "$@"
  else
    return 1
  fi
}

# need_packages NAME...: installs what is missing. Leaves the shell with code 2 and the list when it cannot.
# Where everything is there, it touches neither apt nor the network.
need_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "This is not Debian: make sure that the like of these packages is installed:" "$@" >&2
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0
  mapfile -t -O ${#missing[@]} missing < <(missing_packages "${packages_welcome[@]}")

  echo "Installing: ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  if ! { as_root apt-get update -qq &&
    as_root apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >/dev/null; then
    echo "These packages are missing and could not be installed:" >&2
    printf '  %s\n' "${missing[@]}" >&2
    echo "Install them (apt-get install, as root), then run this again." >&2
    exit 2
  fi
}

# Builds go through ccache where it is installed, and use all cores.
use_all_cores() {
  if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
}
