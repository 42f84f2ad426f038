# Builds LIBRARY in a scratch project that holds nothing but it and the libraries it depends on: a use of anything
# above it, by include or by link, cannot compile there.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SCRATCH}/source)
file(MAKE_DIRECTORY ${SCRATCH}/source)
file(CREATE_LINK ${SOURCE_DIR}/cmake ${SCRATCH}/source/cmake SYMBOLIC)
file(CREATE_LINK ${CMAKE_CURRENT_LIST_DIR}/alone.cmake ${SCRATCH}/source/alone.cmake SYMBOLIC)

# The libraries needed, lowest first: the root lists them in dependency order.
file(STRINGS ${SOURCE_DIR}/CMakeLists.txt order REGEX "^ *add_subdirectory\\(lib")
list(TRANSFORM order REPLACE "^ *add_subdirectory\\((lib[a-z]+)\\).*" "\\1")
set(needed ${LIBRARY})
list(REVERSE order)
foreach(library IN LISTS order)
  if(library IN_LIST needed)
    file(READ ${SOURCE_DIR}/${library}/CMakeLists.txt text)
    string(REGEX MATCHALL "waymark::[a-z]+" below "${text}")
    list(TRANSFORM below REPLACE "waymark::" "lib")
    list(APPEND needed ${below})
  endif()
endforeach()
list(REVERSE order)

set(text "cmake_minimum_required(VERSION 3.25)\nproject(alone LANGUAGES CXX)\n\
list(APPEND CMAKE_MODULE_PATH \${PROJECT_SOURCE_DIR}/cmake)\ninclude(\${PROJECT_SOURCE_DIR}/alone.cmake)\n")
foreach(library IN LISTS order)
  if(library IN_LIST needed)
    file(CREATE_LINK ${SOURCE_DIR}/${library} ${SCRATCH}/source/${library} SYMBOLIC)
    string(APPEND text "add_subdirectory(${library})\n")
  endif()
endforeach()
file(WRITE ${SCRATCH}/source/CMakeLists.txt "${text}")

# An archive does not wait for those below it, which are compiled when it is their turn.
foreach(step IN ITEMS
    "-S;${SCRATCH}/source;-B;${SCRATCH}/build;-G;${GENERATOR};-DCMAKE_CXX_COMPILER=${COMPILER};-DCMAKE_BUILD_TYPE=Debug;-DCMAKE_CXX_FLAGS_DEBUG=-O0;-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON;-DWAYMARK_UNITY=OFF;-DWAYMARK_WITH_OMPL=ON;-DCMAKE_OPTIMIZE_DEPENDENCIES=ON"
    "--build;${SCRATCH}/build;--target;${LIBRARY}/all")
  execute_process(COMMAND ${CMAKE_COMMAND} ${step} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
