# cpack -G DEB: the packages waymark (the command line), libwaymark-dev (libraries and headers) and python3-waymark.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME waymark)
set(WAYMARK_MAINTAINER "The waymark authors <packages@waymark.invalid>" CACHE STRING "Maintainer of Debian packages")
set(CPACK_PACKAGE_CONTACT "${WAYMARK_MAINTAINER}")
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "route instructions in temporal logic, and certified routes")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_ALL tools dev)
set(about "Grounds route instructions in linear temporal logic, plans certified routes.")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME waymark)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "English route instructions to certified routes
${about}
This package has the command line, its maps and its model.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libwaymark-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libboost-graph-dev, libeigen3-dev, libpugixml-dev, libyaml-cpp-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "libraries of waymark for development
${about}
This package has static libraries, headers, and files for CMake and pkg-config.")

set(packages "tools=waymark" "dev=libwaymark-dev")
if(WAYMARK_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  list(APPEND packages "python=python3-waymark")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-waymark)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3-numpy")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python module of waymark
${about}
This package has the module waymark for Python 3, its maps and its model.")
endif()

# What Debian asks of every package: the licence and a changelog, compressed without a time.
find_program(GZIP gzip)
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(pair IN LISTS packages)
  string(REPLACE "=" ";" pair ${pair})
  list(GET pair 0 component)
  list(GET pair 1 name)
  set(folder ${PROJECT_BINARY_DIR}/debian/${name})
  file(READ LICENSE licence)
  file(WRITE ${folder}/copyright "waymark is free software under this licence (MIT):\n\n${licence}")
  file(WRITE ${folder}/changelog "${name} (${PROJECT_VERSION}) unstable; urgency=low\n\n  * See CHANGELOG.md.\n\n"
    " -- ${CPACK_PACKAGE_CONTACT}  ${now}\n")
  execute_process(COMMAND ${GZIP} -9nf ${folder}/changelog COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${folder}/copyright ${folder}/changelog.gz DESTINATION share/doc/${name} COMPONENT ${component})
endforeach()
include(CPack)
