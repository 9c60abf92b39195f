# The interpreter that runs the build's scripts and that the Python module is for: Debian's own, whatever else stands
# earlier on PATH. inkedge_python_missing: what the module lacks, in words; empty: nothing.
if(NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter OPTIONAL_COMPONENTS Development.Module)
set(PYBIND11_NOPYTHON ON)  # it would look for an interpreter of its own
find_package(pybind11 CONFIG QUIET)

set(inkedge_python_missing "")
execute_process(COMMAND ${Python3_EXECUTABLE} -c "import numpy" RESULT_VARIABLE numpy_missing OUTPUT_QUIET ERROR_QUIET)
if(NOT Python3_Development.Module_FOUND)
  list(APPEND inkedge_python_missing python3-dev)
endif()
if(NOT pybind11_FOUND)
  list(APPEND inkedge_python_missing pybind11-dev)
endif()
if(numpy_missing)
  list(APPEND inkedge_python_missing python3-numpy)
endif()
list(JOIN inkedge_python_missing ", " inkedge_python_missing)

if(INKEDGE_PYTHON STREQUAL AUTO)
  set(inkedge_python ON)
  if(INKEDGE_SANITIZE OR NOT PROJECT_IS_TOP_LEVEL)
    set(inkedge_python OFF)  # the interpreter has no sanitizer to go with
  elseif(inkedge_python_missing)
    set(inkedge_python OFF)
    message(STATUS "The Python module is left out: ${Python3_EXECUTABLE} lacks ${inkedge_python_missing}")
  endif()
else()
  set(inkedge_python ${INKEDGE_PYTHON})
  if(inkedge_python AND inkedge_python_missing)
    message(FATAL_ERROR "INKEDGE_PYTHON: expected ${Python3_EXECUTABLE} with ${inkedge_python_missing}, "
                        "found it without")
  endif()
endif()
