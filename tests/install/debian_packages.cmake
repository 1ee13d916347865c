# Makes the Debian packages of the tree BUILD, unpacks them in WORK, runs the program and builds the program EXAMPLE
# against what was unpacked, by CMake package and by pkg-config.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/../project/run.cmake")
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}/packages" "${WORK}/root")
run(_ "${CPACK}" -G DEB --config "${BUILD}/CPackConfig.cmake" -B "${WORK}/packages")

file(GLOB packages "${WORK}/packages/*.deb")
set(names "")
foreach(package IN LISTS packages)
  run(name dpkg-deb --field "${package}" Package)
  string(STRIP "${name}" name)
  list(APPEND names "${name}")
  run(depends dpkg-deb --field "${package}" Depends)
  if(name STREQUAL "exsect" AND NOT depends MATCHES "libc6")
    message(FATAL_ERROR "the program depends on ${depends}")
  elseif(name STREQUAL "libexsect-dev" AND NOT depends MATCHES "libboost-dev.*libgmp-dev")
    message(FATAL_ERROR "libexsect-dev depends on ${depends}")
  endif()
  run(_ dpkg-deb --extract "${package}" "${WORK}/root")
endforeach()
if(NOT "exsect" IN_LIST names OR NOT "libexsect-dev" IN_LIST names)
  message(FATAL_ERROR "the packages are ${names}")
endif()

# On Debian 12 the dependencies are there.
file(STRINGS /etc/os-release release REGEX "^(ID|VERSION_ID)=")
if("ID=debian" IN_LIST release AND "VERSION_ID=\"12\"" IN_LIST release)
  run(_ apt-get --simulate --no-install-recommends install ${packages})
endif()

foreach(name IN LISTS names)
  file(SHA256 "${WORK}/root/usr/share/doc/${name}/copyright" shipped)
  file(SHA256 "${EXSECT_SOURCE_DIR}/LICENSE" licence)
  if(NOT shipped STREQUAL licence)
    message(FATAL_ERROR "${name} comes without the licence")
  endif()
endforeach()

run(version "${WORK}/root/usr/bin/exsect" --version)
if(NOT version STREQUAL "exsect ${VERSION}\n")
  message(FATAL_ERROR "the program says ${version}")
endif()
foreach(USE IN ITEMS package pkg-config)
  execute_process(COMMAND "${CMAKE_COMMAND}" -DUSE=${USE} -DLAYER=solver "-DPREFIX=${WORK}/root/usr" "-DWORK=${WORK}/${USE}"
                          "-DEXSECT_SOURCE_DIR=${EXSECT_SOURCE_DIR}" "-DCOMPILER=${COMPILER}" "-DEXAMPLE=${EXAMPLE}"
                          "-DEXPECTED=${EXPECTED}" -P "${CMAKE_CURRENT_LIST_DIR}/consume.cmake"
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
