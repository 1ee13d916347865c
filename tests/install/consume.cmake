# Builds the program EXAMPLE with a LAYER in WORK as another project would, runs it in EXSECT_SOURCE_DIR and compares
# what it prints with EXPECTED. USE says how exsect is found: package or pkg-config (installed in PREFIX), or
# subdirectory.
include("${CMAKE_CURRENT_LIST_DIR}/../project/run.cmake")
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")

if(USE STREQUAL "pkg-config")
  file(GLOB_RECURSE pc "${PREFIX}/*/exsect.pc")
  cmake_path(GET pc PARENT_PATH pc_dir)
  set(ENV{PKG_CONFIG_PATH} "${pc_dir}")
  run(flags pkg-config --cflags --libs exsect)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(_ "${COMPILER}" -std=c++20 "${EXAMPLE}" -o "${WORK}/consumer" ${flags} "-Wl,-rpath,${pc_dir}/..")
else()
  if(USE STREQUAL "subdirectory")
    set(arguments "-DEXSECT_SOURCE_DIR=${EXSECT_SOURCE_DIR}" -DBUILD_SHARED_LIBS=ON)
  else()
    set(arguments "-DCMAKE_PREFIX_PATH=${PREFIX}")
  endif()
  run(_ "${CMAKE_COMMAND}" -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}" -B "${WORK}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
      "-DEXAMPLE=${EXAMPLE}" "-DLAYER=${LAYER}" ${arguments})
  run(_ "${CMAKE_COMMAND}" --build "${WORK}")
endif()

# BUILD_SHARED_LIBS is honoured, and the library has a version.
if(USE STREQUAL "subdirectory")
  file(GLOB_RECURSE versioned "${WORK}/exsect/libexsect_${LAYER}.so.*.*.*")
  if(NOT versioned)
    message(FATAL_ERROR "there is no versioned shared library of the layer ${LAYER}")
  endif()
endif()

set(PROGRAM "${WORK}/consumer")
include("${CMAKE_CURRENT_LIST_DIR}/../project/compare_output.cmake")
