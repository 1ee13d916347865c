# Compile options every target of exsect shares. Contraction is off so that a
# proved floating-point error bound means the same on every machine.
add_library(exsect_options INTERFACE)
target_compile_options(exsect_options INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
# GCC 12 warns falsely inside std::string's operator+ (GCC bug 105651) once <string> comes precompiled.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(exsect_options INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow
                                                  -Wno-stringop-overread)
endif()
if(EXSECT_WERROR)
  target_compile_options(exsect_options INTERFACE -Werror)
endif()
if(EXSECT_SANITIZE)
  # The instrumentation makes GCC warn falsely inside <regex> (GCC bug 105562); the release build keeps the warning.
  target_compile_options(exsect_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                  -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(exsect_options INTERFACE -fsanitize=address,undefined)
endif()

if(EXSECT_FUZZ)
  target_compile_options(exsect_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# The headers that nearly every file includes, parsed once for each kind of target: Boost's GMP numbers alone cost
# seconds a file. The kinds: `library` for the layers and the program, `tests` with Catch2 and JSON besides, `numbers`
# with nothing else.
# exsect_precompiled(<kind> HEADERS <headers> LIBRARIES <targets> OPTIONS <compile options>)
function(exsect_precompiled kind)
  cmake_parse_arguments(KIND "" "" "HEADERS;LIBRARIES;OPTIONS" ${ARGN})
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/precompiled_${kind}.cpp" CONTENT "" @ONLY)
  add_library(exsect_precompiled_${kind} OBJECT "${CMAKE_CURRENT_BINARY_DIR}/precompiled_${kind}.cpp")
  target_compile_features(exsect_precompiled_${kind} PRIVATE cxx_std_20)
  target_compile_options(exsect_precompiled_${kind} PUBLIC -fPIC ${KIND_OPTIONS})
  target_link_libraries(exsect_precompiled_${kind} PRIVATE Boost::headers ${KIND_LIBRARIES} exsect_options)
  target_precompile_headers(exsect_precompiled_${kind} PRIVATE <boost/multiprecision/gmp.hpp> ${KIND_HEADERS})
endfunction()
set(exsect_containers <algorithm> <array> <memory> <optional> <string> <vector>)
exsect_precompiled(library HEADERS ${exsect_containers})

# The compiler refuses precompiled headers made with other options, so every target has those of its kind, and is
# position-independent.
function(exsect_precompile target kind)
  target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:exsect_precompiled_${kind},INTERFACE_COMPILE_OPTIONS>)
  target_precompile_headers(${target} REUSE_FROM exsect_precompiled_${kind})
endfunction()

# The sources of one room, up to 24 of them, compile as one file: together they take a third of the processor time,
# for they instantiate the same templates. No two files of a room have a local name in common (tests/project/rooms.py).
# Sources with options of their own stay alone.
option(EXSECT_GROUPS "Compile sources in groups: a clean build is faster, one after a change slower" ON)
function(exsect_grouped target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(directory ${target} SOURCE_DIR)
  list(SORT sources)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${directory}")
    cmake_path(GET source PARENT_PATH room)
    string(MAKE_C_IDENTIFIER "${room}" room)
    math(EXPR group "0${size_${room}} / 24")
    math(EXPR size_${room} "0${size_${room}} + 1")
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME folder)
    set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${folder}_${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${EXSECT_GROUPS} UNITY_BUILD_MODE GROUP)
  if(EXSECT_GROUPS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # A source in a group is an included file, whose local types GCC would not see in a type that others could name.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# exsect_brief(<target> <rooms>): what is seldom waited for compiles in a quarter less time with -O1: the whole target, or
# of its sources only the groups of these rooms.
function(exsect_brief target)
  set(option "$<$<CONFIG:Release>:-O1>")
  if(NOT ARGN)
    target_compile_options(${target} PRIVATE ${option})
  endif()
  foreach(room IN LISTS ARGN)
    foreach(group 0 1 2)
      set_source_files_properties("${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/Unity/unity_${room}_${group}_cxx.cxx"
                                  PROPERTIES COMPILE_OPTIONS "${option}")
    endforeach()
  endforeach()
endfunction()

# exsect_layer(<name> HEADERS <public headers> FORMER <layer> DEPENDS <targets> PRIVATE_DEPENDS <targets>)
# builds and installs the library of one layer from the sources beside it and in its rooms, the folders below. A
# public header room/name.h is included as <exsect/layer/name.h>: it gets a one-line forwarding header that only this
# layer's target exports, so an include against the direction of the layers does not compile; the headers themselves
# are what is installed. With FORMER they can still be included as headers of the layer that they were a part of.
# Inside the layer any header is included by its path, "room/name.h".
function(exsect_layer name)
  cmake_parse_arguments(LAYER "" "FORMER" "HEADERS;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(target exsect_${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  if(NOT sources)
    file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/empty.cpp" CONTENT "" @ONLY)
    set(sources "${CMAKE_CURRENT_BINARY_DIR}/empty.cpp")
  endif()
  add_library(${target} ${sources})
  add_library(exsect::${name} ALIAS ${target})

  set(forward "${CMAKE_CURRENT_BINARY_DIR}/include")
  set(former "${CMAKE_CURRENT_BINARY_DIR}/former")
  foreach(header IN LISTS LAYER_HEADERS)
    cmake_path(GET header FILENAME file)
    file(RELATIVE_PATH path "${forward}/exsect/${name}" "${CMAKE_CURRENT_SOURCE_DIR}/${header}")
    file(CONFIGURE OUTPUT "${forward}/exsect/${name}/${file}" CONTENT "#include \"${path}\"\n" @ONLY)
    if(LAYER_FORMER)
      file(CONFIGURE OUTPUT "${former}/exsect/${LAYER_FORMER}/${file}" @ONLY
           CONTENT "#include <exsect/${name}/${file}>  // where it stands now\n")
    endif()
  endforeach()
  target_compile_options(${target} PRIVATE "SHELL:-iquote ${CMAKE_CURRENT_SOURCE_DIR}")
  if(LAYER_FORMER)
    target_include_directories(${target} INTERFACE "$<BUILD_INTERFACE:${former}>")
  endif()
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${forward}>"
                                              "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_compile_features(${target} PUBLIC cxx_std_20)
  # For the arithmetic of balls, in headers, that others compile.
  target_compile_options(${target} INTERFACE $<INSTALL_INTERFACE:-ffp-contract=off>)
  exsect_precompile(${target} library)
  exsect_grouped(${target})
  target_link_libraries(${target} PUBLIC ${LAYER_DEPENDS} PRIVATE ${LAYER_PRIVATE_DEPENDS}
                                                                  $<BUILD_INTERFACE:exsect_options>)
  # Before 1.0 every minor version may change the binary interface.
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    INSTALL_RPATH "$ORIGIN" DEFINE_SYMBOL "" POSITION_INDEPENDENT_CODE ON EXSECT_HEADERS "${LAYER_HEADERS}")

  if(EXSECT_INSTALL)
    install(TARGETS ${target} EXPORT exsectTargets
            LIBRARY COMPONENT Runtime NAMELINK_COMPONENT Development
            ARCHIVE COMPONENT Development)
    if(LAYER_FORMER)
      install(DIRECTORY "${former}/exsect" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT Development)
    endif()
    install(FILES ${LAYER_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/exsect/${name} COMPONENT Development)
  endif()
endfunction()

# The target includes internal headers of the solver's rooms as "room/name.h". Which rooms: tests/project/rooms.py.
function(exsect_uses_rooms layer)
  target_compile_options(exsect_${layer} PRIVATE "SHELL:-iquote ${PROJECT_SOURCE_DIR}/solver")
endfunction()
