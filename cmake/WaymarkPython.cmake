# Is there what the Python module needs? Then WAYMARK_PYTHON is true, and the libraries are compiled so that a shared
# object may hold them. Otherwise a message names what is missing, and everything else is built.
# The module holds the libraries: they are static.
if(BUILD_SHARED_LIBS)
  message(FATAL_ERROR "WAYMARK_WITH_PYTHON goes with static libraries: -DBUILD_SHARED_LIBS=OFF")
endif()
# -DPython_EXECUTABLE=… names an interpreter. Without it, Debian's is preferred, which packages.debian.txt equips.
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python 3.9 COMPONENTS Interpreter Development.Module)
set(missing "")
if(Python_Development.Module_FOUND)
  set(PYBIND11_FINDPYTHON ON)
  find_package(pybind11 2.10 CONFIG)
  if(NOT pybind11_FOUND)
    set(missing " pybind11")
  endif()
else()
  set(missing " Python 3.9 with its headers")
endif()
if(missing)
  message(WARNING "the Python module is left out; missing:${missing} (Debian: ./dev setup python)")
  set(WAYMARK_PYTHON FALSE)
  return()
endif()
set(WAYMARK_PYTHON TRUE)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)  # calls inside a library stay direct
