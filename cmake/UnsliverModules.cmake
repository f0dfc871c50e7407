# One static library a folder of src/, and the installed library made of all of them.

add_library(unsliver_options INTERFACE)
target_compile_features(unsliver_options INTERFACE cxx_std_20)
target_compile_options(unsliver_options INTERFACE
  -Wall -Wextra -Wpedantic $<$<BOOL:${UNSLIVER_WERROR}>:-Werror>
  # GCC 12 sees overlapping copies inside its own std::string::insert.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # Calls within a module need no way round by the dynamic linker, and may be inlined.
  $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>
  # Filters and budgets assume that every operation rounds once: no fused multiply-add behind our back.
  -ffp-contract=off)

if(UNSLIVER_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  add_link_options(-fsanitize=address,undefined)
endif()
if(UNSLIVER_BUILD_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
    message(FATAL_ERROR "UNSLIVER_BUILD_FUZZ needs Clang: configure with -DCMAKE_CXX_COMPILER=clang++")
  endif()
  # Coverage feedback must reach into the library, not only into the fuzzers.
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

set(UNSLIVER_MODULES "")

# unsliver_module(NAME [USES modules...] [HEADERS names...] [LINK targets...])
# src/NAME/*.cpp as target unsliver_NAME. USES: the modules whose headers it may include. HEADERS: its
# public ones, include/unsliver/<name>.hpp. LINK: other people's libraries.
function(unsliver_module name)
  cmake_parse_arguments(ARG "" "" "USES;HEADERS;LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  if(sources)
    add_library(unsliver_${name} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(unsliver_${name} PRIVATE unsliver_options)
    set_target_properties(unsliver_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    set(UNSLIVER_MODULES ${UNSLIVER_MODULES} unsliver_${name} PARENT_SCOPE)
  else()
    add_library(unsliver_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  list(TRANSFORM ARG_USES PREPEND unsliver_)
  target_compile_features(unsliver_${name} ${scope} cxx_std_20)
  target_include_directories(unsliver_${name} ${scope}
    ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(unsliver_${name} ${scope} ${ARG_USES} ${ARG_LINK})
endfunction()

# The exported target unsliver::unsliver: every module's objects in one archive.
function(unsliver_library)
  set(objects "")
  foreach(module ${UNSLIVER_MODULES})
    list(APPEND objects $<TARGET_OBJECTS:${module}>)
  endforeach()
  add_library(unsliver STATIC ${objects})
  add_library(unsliver::unsliver ALIAS unsliver)
  set_target_properties(unsliver PROPERTIES LINKER_LANGUAGE CXX)
  target_compile_features(unsliver PUBLIC cxx_std_20)
  target_include_directories(unsliver PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
  target_link_libraries(unsliver PRIVATE PkgConfig::libdeflate fmt::fmt Threads::Threads)
endfunction()
