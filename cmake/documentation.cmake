# The target docs, and tests that both generators run without a warning: Sphinx makes pages of docs/*.md (MyST reads
# Markdown) and of the Python module's docstrings, Doxygen those of the public headers, which go to api/ beside them.
find_package(Doxygen 1.9 QUIET)
exsect_python_has(has_sphinx sphinx myst_parser)
set(docs_dir "${PROJECT_SOURCE_DIR}/build/docs")
set(api_dir "${PROJECT_BINARY_DIR}/docs/api")

if(DOXYGEN_FOUND)
  set(headers "")
  foreach(layer algebra geometry solver verify implicit)
    get_target_property(public exsect_${layer} EXSECT_HEADERS)
    list(TRANSFORM public PREPEND "${PROJECT_SOURCE_DIR}/${layer}/")
    list(APPEND headers ${public})
  endforeach()
  list(JOIN headers " " DOXYGEN_HEADERS)
  file(MAKE_DIRECTORY "${api_dir}")
  configure_file("${PROJECT_SOURCE_DIR}/docs/Doxyfile.in" "${PROJECT_BINARY_DIR}/docs/Doxyfile" @ONLY)
  set(make_api ${CMAKE_COMMAND} -E env "${DOXYGEN_EXECUTABLE}" "${PROJECT_BINARY_DIR}/docs/Doxyfile")
endif()
if(has_sphinx AND TARGET exsect_python)
  set(make_pages ${CMAKE_COMMAND} -E env "PYTHONPATH=${EXSECT_PYTHON_DIR}" PYTHONDONTWRITEBYTECODE=1
                 "${Python_EXECUTABLE}" -m sphinx -q -W --keep-going -b html -d "${PROJECT_BINARY_DIR}/docs/doctrees")
endif()

if(make_api AND make_pages)
  add_custom_target(docs COMMAND ${make_api} COMMAND ${CMAKE_COMMAND} -E env "EXSECT_API_PAGES=${api_dir}"
                                                     ${make_pages} "${PROJECT_SOURCE_DIR}/docs" "${docs_dir}/html"
                    VERBATIM)
  add_dependencies(docs exsect_python)
else()
  add_custom_target(docs COMMAND ${CMAKE_COMMAND} -E echo "The documentation needs the packages doxygen, python3-sphinx,\
 python3-myst-parser, pybind11-dev and python3-dev" COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()

if(EXSECT_BUILD_TESTS AND NOT EXSECT_SANITIZE)
  if(make_api)
    add_test(NAME "docs: Doxygen without warnings" COMMAND ${make_api})
  else()
    exsect_skipped_test("docs: Doxygen without warnings" "it needs the package doxygen")
  endif()
  if(make_pages)
    add_test(NAME "docs: Sphinx without warnings"
             COMMAND ${make_pages} "${PROJECT_SOURCE_DIR}/docs" "${PROJECT_BINARY_DIR}/docs/pages")
  else()
    exsect_skipped_test("docs: Sphinx without warnings" "it needs the packages python3-sphinx and python3-myst-parser")
  endif()
endif()
