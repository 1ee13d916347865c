# The CMake package (find_package(exsect)) and the pkg-config file; the layers
# install their own libraries and headers.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/exsect")

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/exsectConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/exsectConfig.cmake" INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/exsectConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/exsectConfig.cmake" "${PROJECT_BINARY_DIR}/exsectConfigVersion.cmake"
              "${CMAKE_CURRENT_LIST_DIR}/FindFLINT.cmake" "${CMAKE_CURRENT_LIST_DIR}/FindGMP.cmake"
        DESTINATION "${package_dir}" COMPONENT Development)
install(EXPORT exsectTargets NAMESPACE exsect:: DESTINATION "${package_dir}" COMPONENT Development)

# Relative, so that an installed tree can be moved.
set(pkgconfig_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH EXSECT_PC_PREFIX "/${pkgconfig_dir}" "/")
string(REGEX REPLACE "/$" "" EXSECT_PC_PREFIX "${EXSECT_PC_PREFIX}")

# Static libraries do not carry their own dependencies: the link line names them.
set(EXSECT_PC_LIBS "-lgmp")
if(NOT BUILD_SHARED_LIBS)
  get_target_property(flint_libraries FLINT::FLINT INTERFACE_LINK_LIBRARIES)
  list(REMOVE_ITEM flint_libraries GMP::GMP)
  list(JOIN flint_libraries " " flint_libraries)
  set(EXSECT_PC_LIBS "${flint_libraries} -ltbb ${EXSECT_PC_LIBS}")
endif()
configure_file("${CMAKE_CURRENT_LIST_DIR}/exsect.pc.in" "${PROJECT_BINARY_DIR}/exsect.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/exsect.pc" DESTINATION "${pkgconfig_dir}" COMPONENT Development)

# The licence goes with every package.
set(licensed_Program exsect)
set(licensed_Development libexsect-dev)
set(licensed_Runtime libexsect${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(components Development)
if(EXSECT_BUILD_CLI)
  list(APPEND components Program)
endif()
if(BUILD_SHARED_LIBS)
  list(APPEND components Runtime)
endif()
foreach(component IN LISTS components)
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" RENAME copyright COMPONENT ${component}
          DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${licensed_${component}}")
endforeach()
