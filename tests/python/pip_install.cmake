# Installs a copy of the tree into an environment of its own in WORK, as README.md says, and runs the tests of the
# module there. The compiled part comes from the tree EXSECT_BUILD_DIR, so that nothing is compiled twice.
include("${CMAKE_CURRENT_LIST_DIR}/../project/run.cmake")
file(REMOVE_RECURSE "${WORK}")
foreach(entry IN ITEMS CMakeLists.txt README.md pyproject.toml setup.py python)
  file(COPY "${EXSECT_SOURCE_DIR}/${entry}" DESTINATION "${WORK}/source")
endforeach()

run(_ "${PYTHON}" -m venv --without-pip --system-site-packages "${WORK}/environment")
set(python "${WORK}/environment/bin/python")
set(ENV{EXSECT_BUILD_DIR} "${EXSECT_BUILD_DIR}")
set(ENV{PIP_DISABLE_PIP_VERSION_CHECK} 1)
set(ENV{PYTHONDONTWRITEBYTECODE} 1)
run(_ "${python}" -m pip install --quiet --no-build-isolation --no-deps --no-index "${WORK}/source")

set(check [[
import importlib.metadata, pathlib, sys, exsect
assert pathlib.Path(exsect.__file__).is_relative_to(sys.prefix), exsect.__file__
assert importlib.metadata.version("exsect") == exsect.__version__
]])
run(_ "${python}" -c "${check}")
run(_ "${python}" -m pytest -q -p no:cacheprovider -k "program or documented" "${CMAKE_CURRENT_LIST_DIR}/test_module.py")
