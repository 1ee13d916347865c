# The Python interpreter of the module, of tests and of the documentation. On Debian it is Debian's, to which
# Debian's packages (pybind11, numpy, pytest, ...) belong; -DPython_EXECUTABLE=... chooses another one.
if(EXISTS /usr/bin/python3 AND NOT DEFINED Python_EXECUTABLE AND NOT DEFINED Python_ROOT_DIR)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python 3.9 QUIET COMPONENTS Interpreter OPTIONAL_COMPONENTS Development.Module)

# exsect_python_has(<variable> <modules>...): whether the interpreter can import all of the modules.
function(exsect_python_has variable)
  set(${variable} FALSE PARENT_SCOPE)
  if(Python_Interpreter_FOUND)
    list(JOIN ARGN "," modules)
    execute_process(COMMAND "${Python_EXECUTABLE}" -c "import ${modules}" RESULT_VARIABLE status ERROR_QUIET)
    if(status EQUAL 0)
      set(${variable} TRUE PARENT_SCOPE)
    endif()
  endif()
endfunction()
