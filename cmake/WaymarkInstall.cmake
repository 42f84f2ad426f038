# cmake --install: the libraries with their headers, the command line with its helpers, the data it looks up, and a
# package for find_package(waymark). tests/install builds a project against the installed tree.
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY WAYMARK_LIBRARIES)
install(TARGETS ${libraries} EXPORT waymark ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
get_property(folders GLOBAL PROPERTY WAYMARK_FOLDERS)
list(REMOVE_DUPLICATES folders)
install(DIRECTORY ${folders} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/waymark FILES_MATCHING PATTERN "*.hpp"
  PATTERN "json_reader.hpp" EXCLUDE)  # of readers only: it brings the JSON library along

install(TARGETS waymark RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS waymark-layout waymark-lab RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/waymark)
if(TARGET waymark-serve)
  install(TARGETS waymark-serve RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/waymark)
endif()
install(DIRECTORY data/maps data/models data/words data/language data/schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/waymark)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/waymark)
install(EXPORT waymark NAMESPACE waymark:: DESTINATION ${package} FILE waymarkTargets.cmake)
configure_package_config_file(cmake/waymarkConfig.cmake.in ${PROJECT_BINARY_DIR}/waymarkConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/waymarkConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/waymarkConfig.cmake ${PROJECT_BINARY_DIR}/waymarkConfigVersion.cmake
  DESTINATION ${package})
