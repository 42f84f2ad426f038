# cmake --build … --target static: waymark for people without root, static/waymark-VERSION-SYSTEM.tar.xz in the build.
# The archive has the command line and its experiments, which need the kernel and no library of the machine, and their
# data. It has no helper that links Graphviz, cairo, OMPL or cpp-httplib: Debian has these as shared libraries only.
if(BUILD_SHARED_LIBS OR WAYMARK_SANITIZE OR NOT CMAKE_SYSTEM_NAME STREQUAL Linux)
  return()
endif()
string(TOLOWER waymark-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR} archive)
set(folder ${PROJECT_BINARY_DIR}/static/${archive})
set(programs "")
foreach(program waymark waymark-lab)  # the same objects, linked in another way
  add_executable(${program}-static EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${program}>)
  get_target_property(libraries ${program} LINK_LIBRARIES)
  target_link_libraries(${program}-static PRIVATE ${libraries})
  target_link_options(${program}-static PRIVATE -static)
  list(APPEND programs ${program}-static)
endforeach()
set(data "")
foreach(part maps models schemas words language workspaces experiments)
  list(APPEND data COMMAND ${CMAKE_COMMAND} -E copy_directory ${PROJECT_SOURCE_DIR}/data/${part}
    ${folder}/share/waymark/${part})
endforeach()
add_custom_target(static
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}/bin ${folder}/libexec/waymark
  COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_FILE:waymark-static> ${folder}/bin/waymark
  COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_FILE:waymark-lab-static> ${folder}/libexec/waymark/waymark-lab
  COMMAND ${CMAKE_STRIP} ${folder}/bin/waymark ${folder}/libexec/waymark/waymark-lab
  COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/LICENSE ${folder}/LICENSE
  ${data}
  COMMAND ${CMAKE_COMMAND} -E rm -f ${folder}/share/waymark/words/fetch
  COMMAND ${CMAKE_COMMAND} -E chdir static ${CMAKE_COMMAND} -E tar cJf ${archive}.tar.xz ${archive}
  DEPENDS ${programs} WORKING_DIRECTORY ${PROJECT_BINARY_DIR} VERBATIM)
