# Targets that look after the style of the sources:
#   format        rewrite them with clang-format
#   format-check  fail if that would change anything (also a test)
#   tidy          run clang-tidy on all of them
# Version 14 is what Debian 12 brings; others lay out some lines differently.
file(GLOB_RECURSE style_sources CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}"
     algebra/*.h algebra/*.cpp geometry/*.h geometry/*.cpp solver/*.h solver/*.cpp cli/*.h cli/*.cpp
     tests/*.h tests/*.cpp bench/*.h bench/*.cpp docs/*.cpp)
find_program(CLANG_FORMAT NAMES clang-format-14)
find_program(RUN_CLANG_TIDY NAMES run-clang-tidy-14)
mark_as_advanced(CLANG_FORMAT RUN_CLANG_TIDY)

if(CLANG_FORMAT)
  add_custom_target(format COMMAND ${CLANG_FORMAT} -i ${style_sources} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  set(format_check ${CLANG_FORMAT} --dry-run --Werror ${style_sources})
  add_custom_target(format-check COMMAND ${format_check} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  if(EXSECT_BUILD_TESTS)
    add_test(NAME "style: clang-format" COMMAND ${format_check} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  endif()
endif()
if(RUN_CLANG_TIDY)
  add_custom_target(tidy COMMAND ${RUN_CLANG_TIDY} -quiet -p "${PROJECT_BINARY_DIR}"
                                 "^${PROJECT_SOURCE_DIR}/(algebra|geometry|solver|cli)/"
                         WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
endif()
