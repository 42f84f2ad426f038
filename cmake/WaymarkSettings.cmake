# What every target of the project shares: the language, the warnings, where binaries go.
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE ccache)  # used where it is there, never asked for
if(CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")  # a precompiled header with its time in it is new to every compiler cache
  add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
endif()

add_library(waymark_settings INTERFACE)
target_compile_options(waymark_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<BOOL:${PROJECT_IS_TOP_LEVEL}>:-Werror>  # somebody else's project may meet a newer compiler
  # g++ 12 warns inside std::string's operator+ (GCC bug 105651), under other names too once its header is precompiled.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>)

if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")  # sets count bits; every processor since 2008 has the instruction
  add_compile_options(-mpopcnt)
endif()

set(WAYMARK_SANITIZE "" CACHE STRING "Sanitizers to build everything with, such as address,undefined")
if(WAYMARK_SANITIZE)
  add_compile_options(-fsanitize=${WAYMARK_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${WAYMARK_SANITIZE})
endif()

# One kind of code for programs and for the Python module, which is a shared object: nothing is compiled twice, and all
# share precompiled headers. Calls inside a library stay direct.
if(NOT WAYMARK_SANITIZE)
  add_compile_options(-fPIC $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
endif()

# What is not measured need not be fast, and is compiled in little more than half the time: for tests, and for tools under
# sanitizers. The libraries are what is run most there.
function(waymark_compile_quickly)
  if(WAYMARK_SANITIZE)
    add_compile_options(-O0)
  else()
    add_compile_options($<$<CONFIG:Release>:-O1>)
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread>)  # bug 105651 again, at -O1
  endif()
endfunction()

# Half of the time of a small source goes into reading headers. Two means, both invisible to the sources, which include
# what they use; the preset `tidy` and `./dev alone` build without either.
option(WAYMARK_UNITY "Compile the sources of a room together, a few at a time" ON)

# Precompiles the standard headers that nearly every file includes, and those in ARGN, once for all targets of a kind
# (libraries, tools, tests), whose compiler options are the same. The first target of a kind provides them. A program of
# a position-independent build goes without, since -fPIE is another option than the -fPIC of the libraries.
set(WAYMARK_STANDARD_HEADERS <algorithm> <array> <bit> <charconv> <cmath> <compare> <cstddef> <cstdint> <deque> <functional>
  <iterator> <limits> <map> <memory> <numeric> <optional> <queue> <set> <span> <sstream> <stdexcept> <stop_token> <string>
  <string_view> <tuple> <unordered_map> <unordered_set> <utility> <variant> <vector>)
function(waymark_precompile kind target)
  get_target_property(type ${target} TYPE)
  if(CMAKE_POSITION_INDEPENDENT_CODE AND type STREQUAL EXECUTABLE)
    return()
  endif()
  get_property(provider GLOBAL PROPERTY WAYMARK_PRECOMPILED_${kind})
  if(provider)
    target_precompile_headers(${target} REUSE_FROM ${provider})
    return()
  endif()
  target_precompile_headers(${target} PRIVATE ${WAYMARK_STANDARD_HEADERS} ${ARGN})
  set_property(GLOBAL PROPERTY WAYMARK_PRECOMPILED_${kind} ${target})
endfunction()

# Compiles the sources of each room of a target together, six at a time. Names in unnamed namespaces are therefore
# unique within a room; the sources and rooms in ARGN, whose names are not, are compiled file by file.
function(waymark_compile_rooms target)
  if(NOT WAYMARK_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(room ${source} DIRECTORY)
    if(NOT source MATCHES "\\.cpp$" OR source IN_LIST ARGN OR (room AND room IN_LIST ARGN))
      continue()
    endif()
    string(MAKE_C_IDENTIFIER "room_${room}" room)
    math(EXPR ${room} "${${room}} + 1")
    math(EXPR part "(${${room}} - 1) / 6")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room}_${part})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# Replaces the patterns in a list of sources by the files of the current folder that match them.
function(waymark_expand list)
  foreach(source IN LISTS ${list})
    if(source MATCHES "\\*")
      file(GLOB source CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${source})
    endif()
    list(APPEND sources ${source})
  endforeach()
  set(${list} ${sources} PARENT_SCOPE)
endfunction()

# A shared library has the symbols of namespace waymark and no others. Before version 1, every minor version has an ABI
# of its own.
function(waymark_share target)
  set(script ${PROJECT_SOURCE_DIR}/cmake/waymark.map)
  set_target_properties(${target} PROPERTIES DEFINE_SYMBOL "" LINK_DEPENDS ${script} INSTALL_RPATH "\$ORIGIN"
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_link_options(${target} PRIVATE LINKER:--version-script=${script} LINKER:--no-undefined)
endfunction()

# waymark_library(<area> SOURCES <file>... DEPENDS <target>... PRIVATE_DEPENDS <target>...
#   APART <file>...)
# One library lib<area>, static unless BUILD_SHARED_LIBS is on, known to others as waymark::<area>, included as
# "lib<area>/name.hpp".
# SOURCES stand in dependency order: a file may include only files of the same library that stand before it. `room/*.cpp`
# names all sources of a room, which do not include each other in a circle.
function(waymark_library area)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS;APART" ${ARGN})
  set(target waymark_${area})
  waymark_expand(ARG_SOURCES)
  add_library(${target} ${ARG_SOURCES})
  add_library(waymark::${area} ALIAS ${target})
  if(BUILD_SHARED_LIBS)
    waymark_share(${target})
  endif()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${area})
  set_property(GLOBAL APPEND PROPERTY WAYMARK_LIBRARIES ${target})  # what cmake --install exports,
  set_property(GLOBAL APPEND PROPERTY WAYMARK_FOLDERS ${CMAKE_CURRENT_SOURCE_DIR})  # and where the headers are
  target_compile_features(${target} PUBLIC cxx_std_20)
  waymark_precompile(libraries ${target})
  waymark_compile_rooms(${target} ${ARG_APART})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/waymark>)
  if(WAYMARK_FUZZ)  # libFuzzer steers by what the libraries do; tests and tools are not slowed by being watched
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS}
    PRIVATE $<BUILD_INTERFACE:waymark_settings> ${ARG_PRIVATE_DEPENDS})
endfunction()
