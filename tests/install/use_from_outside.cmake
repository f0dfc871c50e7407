# Builds and runs the consumer in one WAY: find_package, add_subdirectory or pkg_config. The work folder's name
# holds a space and a plus sign: an install must survive them.

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
set(prefix "${WORK_DIR}/a prefix+")
set(consumer ${SOURCE_DIR}/tests/install/consumer)
set(build ${WORK_DIR}/build)

if(NOT WAY STREQUAL add_subdirectory)
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
endif()

if(WAY STREQUAL pkg_config)
  file(GLOB_RECURSE pc_file ${prefix}/unsliver.pc)
  cmake_path(GET pc_file PARENT_PATH pc_dir)
  set(ENV{PKG_CONFIG_PATH} ${pc_dir})
  execute_process(COMMAND ${PKG_CONFIG} --cflags --libs unsliver OUTPUT_VARIABLE flags
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  file(MAKE_DIRECTORY ${build})
  run(${CXX} -std=c++20 ${consumer}/main.cpp ${flags} -o ${build}/consumer)
else()
  # Warnings are errors here too: the flags of the build under test, whose compilations ccache then remembers.
  run(${CMAKE_COMMAND} -S ${consumer} -B ${build} -G Ninja -D CMAKE_BUILD_TYPE=${BUILD_TYPE}
      -D CMAKE_CXX_COMPILER=${CXX} -D WAY=${WAY} -D UNSLIVER_SOURCE_DIR=${SOURCE_DIR}
      -D UNSLIVER_WERROR=ON -D CMAKE_PREFIX_PATH=${prefix})
  run(${CMAKE_COMMAND} --build ${build})
endif()
run(${build}/consumer)
