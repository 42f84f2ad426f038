# Debian's Graphviz exports a .pc file and no CMake target: wrapped here once as waymark::gvc.
find_package(PkgConfig REQUIRED)
pkg_check_modules(WAYMARK_GVC REQUIRED IMPORTED_TARGET libgvc libcgraph)
add_library(waymark_gvc INTERFACE)
add_library(waymark::gvc ALIAS waymark_gvc)
# Its headers are not ours to warn about.
get_target_property(waymark_gvc_includes PkgConfig::WAYMARK_GVC INTERFACE_INCLUDE_DIRECTORIES)
target_include_directories(waymark_gvc SYSTEM INTERFACE ${waymark_gvc_includes})
target_link_libraries(waymark_gvc INTERFACE ${WAYMARK_GVC_LINK_LIBRARIES})
