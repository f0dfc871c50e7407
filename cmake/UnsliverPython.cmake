# Finds what the Python package needs and decides whether it is built: by default in projects of our own where
# pybind11 and the headers of Python are found, and never under the sanitizers, which would have to be loaded
# before the interpreter.

if(PROJECT_IS_TOP_LEVEL AND NOT UNSLIVER_SANITIZE)
  find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10 CONFIG QUIET)
endif()
if(Python_FOUND AND pybind11_FOUND)
  set(have_pybind11 ON)
else()
  set(have_pybind11 OFF)
endif()
option(UNSLIVER_BUILD_PYTHON "Build the Python package" ${have_pybind11})
if(UNSLIVER_BUILD_PYTHON AND NOT have_pybind11)
  message(FATAL_ERROR "UNSLIVER_BUILD_PYTHON needs pybind11 2.10 or later and Python's headers "
                      "(Debian: pybind11-dev, python3-dev), and no UNSLIVER_SANITIZE")
endif()
