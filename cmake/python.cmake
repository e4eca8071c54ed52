# Whether the Python package is built, CANDELA_HAS_PYTHON, and what it needs: a Python with its headers and NumPy, and
# nanobind, which lies in that Python or in build/venv. `scripts/setup` makes the Python there that has all of it, with what
# the tests import.

set(CANDELA_BUILD_PYTHON AUTO CACHE STRING "Build the Python package: ON, OFF, or AUTO: where nanobind is found")
set_property(CACHE CANDELA_BUILD_PYTHON PROPERTY STRINGS AUTO ON OFF)
set(CANDELA_PYTHON_INSTALL_DIR "" CACHE STRING
  "Where `cmake --install` puts the Python package, under the prefix, such as lib/python3/dist-packages; empty: nowhere")
set(CANDELA_HAS_PYTHON FALSE)
if(NOT CANDELA_BUILD_PYTHON OR NOT PROJECT_IS_TOP_LEVEL)
  set(candela_python_missing "CANDELA_BUILD_PYTHON is OFF")
  return()
endif()
# Under sanitizers Python would need their runtime too.
if(CANDELA_SANITIZE)
  set(candela_python_missing "it is not built with sanitizers")
  return()
endif()

set(candela_venv_python ${PROJECT_SOURCE_DIR}/build/venv/bin/python)
if(NOT Python_EXECUTABLE AND NOT SKBUILD AND EXISTS ${candela_venv_python})
  set(Python_EXECUTABLE ${candela_venv_python})
endif()
find_package(Python 3.9 COMPONENTS Interpreter Development.Module)
if(Python_Development.Module_FOUND)
  foreach(candela_python IN ITEMS ${Python_EXECUTABLE} ${candela_venv_python})
    if(NOT nanobind_FOUND)
      execute_process(COMMAND ${candela_python} -m nanobind --cmake_dir
        OUTPUT_VARIABLE nanobind_ROOT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
      find_package(nanobind 3.1 CONFIG QUIET)
    endif()
  endforeach()
  # The module is imported when its stub is made.
  execute_process(COMMAND ${Python_EXECUTABLE} -c "import numpy"
    RESULT_VARIABLE candela_numpy_status OUTPUT_QUIET ERROR_QUIET)
endif()
if(NOT nanobind_FOUND)
  set(candela_python_missing "no Python with headers and nanobind was found: scripts/setup makes one in build/venv")
elseif(NOT candela_numpy_status EQUAL 0)
  set(candela_python_missing "${Python_EXECUTABLE} lacks NumPy")
else()
  set(CANDELA_HAS_PYTHON TRUE)
endif()
if(NOT CANDELA_HAS_PYTHON AND NOT CANDELA_BUILD_PYTHON STREQUAL AUTO)
  message(FATAL_ERROR "CANDELA_BUILD_PYTHON is ON, but ${candela_python_missing}")
elseif(NOT CANDELA_HAS_PYTHON)
  message(STATUS "The Python package will not be built: ${candela_python_missing}")
endif()
