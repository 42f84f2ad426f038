# cmake --install: the libraries with their headers, the command line, and a package for find_package(waymark).
# tests/install builds a project against the installed tree.
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY WAYMARK_LIBRARIES)
install(TARGETS ${libraries} EXPORT waymark
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries NAMELINK_COMPONENT dev)
get_property(folders GLOBAL PROPERTY WAYMARK_FOLDERS)
list(REMOVE_DUPLICATES folders)
install(DIRECTORY ${folders} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/waymark COMPONENT dev FILES_MATCHING PATTERN "*.hpp"
  PATTERN "json_reader.hpp" EXCLUDE)  # of readers only: it brings the JSON library along

if(TARGET waymark)
  include(WaymarkInstallTools)
endif()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/waymark)
install(EXPORT waymark NAMESPACE waymark:: DESTINATION ${package} FILE waymarkTargets.cmake
  COMPONENT dev)
configure_package_config_file(cmake/waymarkConfig.cmake.in ${PROJECT_BINARY_DIR}/waymarkConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/waymarkConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/waymarkConfig.cmake ${PROJECT_BINARY_DIR}/waymarkConfigVersion.cmake
  DESTINATION ${package} COMPONENT dev)

# From lib/pkgconfig, or lib/x86_64-linux-gnu/pkgconfig, up to the prefix.
string(REGEX REPLACE "[^/]+" ".." WAYMARK_PC_UP ${CMAKE_INSTALL_LIBDIR})
# A pkg-config file for each library, waymark-ltl.pc and so on: what a library is linked with, public or not, is
# required, for the libraries may be static.
foreach(library IN LISTS libraries)
  string(REPLACE "waymark_" "" area ${library})
  get_target_property(links ${library} INTERFACE_LINK_LIBRARIES)
  set(requires "")
  set(libs "")
  foreach(link IN LISTS links)
    if(link MATCHES "waymark(::|_)(ltl|automata|neural|plan|learn|parser)")
      list(APPEND requires waymark-${CMAKE_MATCH_2})
    elseif(link MATCHES "Eigen3::Eigen")
      list(APPEND requires eigen3)
    elseif(link MATCHES "INSTALL_INTERFACE:ompl")
      list(APPEND requires ompl)
    elseif(link MATCHES "pugixml")
      list(APPEND requires pugixml)
    elseif(link MATCHES "yaml-cpp")
      list(APPEND requires yaml-cpp)
    elseif(link MATCHES "Threads::Threads")
      string(APPEND libs " -pthread")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES requires)
  list(JOIN requires ", " requires)
  configure_file(cmake/waymark.pc.in ${PROJECT_BINARY_DIR}/pkgconfig/waymark-${area}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/waymark-${area}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT dev)
endforeach()
