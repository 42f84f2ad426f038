# cpack -G DEB: the packages waymark (the command line), libwaymark-dev (headers, and static libraries), python3-waymark,
# waymark-farm (for mpirun); and with shared libraries libwaymark0.1, named by their ABI.
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
set(CPACK_COMPONENTS_ALL dev)
set(packages "dev=libwaymark-dev")
set(about "Grounds route instructions in linear temporal logic, plans certified routes.")

if(TARGET waymark)
  list(APPEND CPACK_COMPONENTS_ALL tools)
  list(APPEND packages "tools=waymark")
endif()
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME waymark)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "English route instructions to certified routes
${about}
This package has the command line, its maps and its model.")

if(TARGET waymark-farm)
  list(APPEND CPACK_COMPONENTS_ALL farm)
  list(APPEND packages "farm=waymark-farm")
  set(CPACK_DEBIAN_FARM_PACKAGE_NAME waymark-farm)
  set(CPACK_DEBIAN_FARM_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_FARM_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_FARM_PACKAGE_DEPENDS "waymark (= ${PROJECT_VERSION}), openmpi-bin")
  set(CPACK_COMPONENT_FARM_DESCRIPTION "batches and experiments of waymark among the ranks of mpirun
${about}
This package has the program that waymark becomes under mpirun.")
endif()

if(TARGET waymark-distributed)
  list(APPEND CPACK_COMPONENTS_ALL distributed)
  list(APPEND packages "distributed=waymark-distributed")
  set(CPACK_DEBIAN_DISTRIBUTED_PACKAGE_NAME waymark-distributed)
  set(CPACK_DEBIAN_DISTRIBUTED_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_DISTRIBUTED_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_DISTRIBUTED_PACKAGE_DEPENDS "waymark (= ${PROJECT_VERSION}), openmpi-bin")
  set(CPACK_COMPONENT_DISTRIBUTED_DESCRIPTION "planning cases of waymark among the ranks of mpirun
${about}
This package has the program that waymark plan --case becomes under mpirun.")
endif()

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libwaymark-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(needed "")
if(plan IN_LIST WAYMARK_LIBRARIES)
  set(needed "libboost-graph-dev, libeigen3-dev, libpugixml-dev, libyaml-cpp-dev")
endif()
set(kind "static libraries, headers,")
if(BUILD_SHARED_LIBS)
  set(abi ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set(kind "headers,")
  list(APPEND CPACK_COMPONENTS_ALL libraries)
  list(APPEND packages "libraries=libwaymark${abi}")
  list(APPEND needed "libwaymark${abi} (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME libwaymark${abi})
  set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
  set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_LIBRARIES_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/triggers)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "libwaymark${abi} (= ${PROJECT_VERSION})")
  foreach(library ${WAYMARK_LIBRARIES})
    list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib${library})
  endforeach()
  set(CPACK_COMPONENT_LIBRARIES_DESCRIPTION "shared libraries of waymark
${about}
This package has the shared libraries.")
endif()
list(JOIN needed ", " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS)
if(TARGET waymark_motion)
  set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS libompl-dev)
endif()
set(CPACK_COMPONENT_DEV_DESCRIPTION "libraries of waymark for development
${about}
This package has ${kind} and files for CMake and pkg-config.")

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
