# `pip install` into a fresh environment, offline, with the packages of the system; then the consumer.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY WORKING_DIRECTORY ${WORK_DIR})
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})
# The flags of the build under test, whose compilations ccache then remembers.
set(ENV{CMAKE_ARGS} "-DUNSLIVER_WERROR=ON -DCMAKE_CXX_COMPILER=${CXX}")
run(${PYTHON} -m venv --system-site-packages environment)
run(environment/bin/pip install --no-index --no-build-isolation --no-deps ${SOURCE_DIR})
run(environment/bin/python ${SOURCE_DIR}/examples/quick_start.py)
