# Warnings are errors for those who work on exsect, and for nobody else: in the presets debug, asan and tidy, not in
# those that newcomers build, and not without a preset, as pip and other projects build it (tried in WORK).
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
foreach(preset IN ITEMS debug asan tidy release package fuzz)
  execute_process(COMMAND "${CMAKE_COMMAND}" -N --preset ${preset} WORKING_DIRECTORY "${EXSECT_SOURCE_DIR}"
                  OUTPUT_VARIABLE variables COMMAND_ERROR_IS_FATAL ANY)
  string(FIND "${variables}" "EXSECT_WERROR=\"ON\"" position)
  if(preset MATCHES "^(debug|asan|tidy)$" AND position EQUAL -1)
    message(SEND_ERROR "warnings are no errors in the preset ${preset}")
  elseif(preset MATCHES "^(release|package|fuzz)$" AND NOT position EQUAL -1)
    message(SEND_ERROR "warnings are errors in the preset ${preset}")
  endif()
endforeach()

file(REMOVE_RECURSE "${WORK}")
run(_ "${CMAKE_COMMAND}" -G Ninja -S "${EXSECT_SOURCE_DIR}" -B "${WORK}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
    -DEXSECT_BUILD_TESTS=OFF -DEXSECT_BUILD_PYTHON=OFF)
file(READ "${WORK}/build.ninja" build)
if(build MATCHES " -Werror")
  message(SEND_ERROR "warnings are errors without a preset")
endif()
