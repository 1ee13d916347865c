# Targets that look after the layout of the sources:
#   format        rewrite them with clang-format
#   format-check  fail if that would change anything (also a test)
# The preset tidy runs clang-tidy. Version 14 is what Debian 12 brings; others lay out some lines differently.
set(style_folders algebra geometry solver verify implicit checker output certificate cli tests bench docs python)
list(TRANSFORM style_folders APPEND "/*.h" OUTPUT_VARIABLE style_headers)
list(TRANSFORM style_folders APPEND "/*.cpp" OUTPUT_VARIABLE style_files)
file(GLOB_RECURSE style_sources CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" ${style_headers} ${style_files})
find_program(CLANG_FORMAT NAMES clang-format-14)
mark_as_advanced(CLANG_FORMAT)

if(CLANG_FORMAT)
  add_custom_target(format COMMAND ${CLANG_FORMAT} -i ${style_sources} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  set(format_check ${CLANG_FORMAT} --dry-run --Werror ${style_sources})
  add_custom_target(format-check COMMAND ${format_check} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  if(EXSECT_BUILD_TESTS)
    add_test(NAME "style: clang-format" COMMAND ${format_check} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  endif()
endif()
