# OMPL as the target waymark::ompl. Debian's package exports variables, and names libraries that OMPL was built with
# but that a program using it neither includes nor links (one of them without its path).
if(NOT TARGET waymark::ompl)
  find_package(ompl 1.5 REQUIRED CONFIG HINTS /usr/share/ompl/cmake)
  find_package(Eigen3 3.4 REQUIRED CONFIG)
  find_package(Boost 1.74 REQUIRED CONFIG)
  add_library(waymark::ompl INTERFACE IMPORTED GLOBAL)
  target_include_directories(waymark::ompl SYSTEM INTERFACE ${OMPL_INCLUDE_DIR})
  list(GET OMPL_LIBRARIES 0 ompl_library)
  target_link_libraries(waymark::ompl INTERFACE ${ompl_library} Eigen3::Eigen Boost::headers)
endif()
