# FLINT::FLINT, with Arb: part of FLINT from version 3, a library of its own
# (Debian: flint-arb, elsewhere: arb) beside FLINT 2.
find_path(FLINT_INCLUDE_DIR NAMES flint/flint.h)
find_library(FLINT_LIBRARY NAMES flint)
find_path(GMP_INCLUDE_DIR NAMES gmp.h)
find_library(GMP_LIBRARY NAMES gmp)
find_library(MPFR_LIBRARY NAMES mpfr)

if(FLINT_INCLUDE_DIR)
  file(STRINGS "${FLINT_INCLUDE_DIR}/flint/flint.h" _flint_version REGEX "define[ \t]+(__FLINT_RELEASE|FLINT_VERSION) ")
  string(REGEX MATCH "([0-9]+\\.[0-9]+[.0-9]*)\"" _ "${_flint_version}")
  set(FLINT_VERSION "${CMAKE_MATCH_1}")
endif()

set(_flint_required FLINT_LIBRARY FLINT_INCLUDE_DIR GMP_LIBRARY GMP_INCLUDE_DIR MPFR_LIBRARY)
set(_flint_link ${FLINT_LIBRARY})
if(FLINT_INCLUDE_DIR AND NOT EXISTS "${FLINT_INCLUDE_DIR}/flint/arb.h")
  find_path(ARB_INCLUDE_DIR NAMES arb.h)
  find_library(ARB_LIBRARY NAMES flint-arb arb)
  list(APPEND _flint_required ARB_LIBRARY ARB_INCLUDE_DIR)
  set(_flint_link ${ARB_LIBRARY} ${FLINT_LIBRARY})
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLINT REQUIRED_VARS ${_flint_required} VERSION_VAR FLINT_VERSION)

if(FLINT_FOUND AND NOT TARGET FLINT::FLINT)
  add_library(FLINT::FLINT INTERFACE IMPORTED)
  set_target_properties(FLINT::FLINT PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${FLINT_INCLUDE_DIR};${GMP_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${_flint_link};${MPFR_LIBRARY};${GMP_LIBRARY}")
endif()
