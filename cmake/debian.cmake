# Debian packages, by cpack -G DEB: exsect (the program), libexsect-dev, and with BUILD_SHARED_LIBS the libraries in a
# package named after their version. The preset package sets what they need.
set(CPACK_PACKAGE_VENDOR "The exsect authors")
set(CPACK_PACKAGE_CONTACT "The exsect authors <exsect@exsect.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENTS_ALL Program Development)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME exsect)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION math)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "exact, certified intersection of biquadratic Bezier patches
 The program exsect finds all of the intersection of two biquadratic Bezier
 surface patches with a proof that nothing is missing.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libexsect-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "exact, certified intersection of patches, development files
 Headers, libraries, CMake package and pkg-config file of exsect.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libboost-dev (>= ${EXSECT_BOOST_VERSION}), libgmp-dev")

if(BUILD_SHARED_LIBS)
  set(exsect_runtime "libexsect${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
  list(APPEND CPACK_COMPONENTS_ALL Runtime)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME ${exsect_runtime})
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
  set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "exact, certified intersection of patches, shared libraries
 The libraries of exsect that programs load.")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${exsect_runtime} (= ${PROJECT_VERSION})")
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", ${exsect_runtime} (= ${PROJECT_VERSION})")
  # Programs of the first package load libraries of another one that is made at the same time.
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/algebra" "${PROJECT_BINARY_DIR}/geometry"
                                                  "${PROJECT_BINARY_DIR}/solver" "${PROJECT_BINARY_DIR}/verify"
                                                  "${PROJECT_BINARY_DIR}/implicit")
else()
  # Static libraries: whoever links them links FLINT. From version 3 it contains Arb.
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libflint-dev, libtbb-dev")
  if(ARB_LIBRARY)
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libflint-arb-dev")
  endif()
endif()
include(CPack)
