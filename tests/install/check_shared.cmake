# Builds WAYMARK's libraries LIBRARIES shared, with no package but the compiler in sight, installs them in SCRATCH, and
# uses them by CMake and by pkg-config. What they export is looked at.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SCRATCH})
set(prefix ${SCRATCH}/prefix)
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE said COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  set(said "${said}" PARENT_SCOPE)
endfunction()

set(none "")
foreach(package Boost Eigen3 nlohmann_json CLI11 GTest PkgConfig pugixml ompl)
  list(APPEND none -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
run(${CMAKE_COMMAND} -S ${WAYMARK} -B ${SCRATCH}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
  -DCMAKE_BUILD_TYPE=Quick -DCMAKE_CXX_FLAGS=-O0 -DBUILD_SHARED_LIBS=ON "-DWAYMARK_LIBRARIES=ltl\;automata" ${none})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build --parallel 2)
run(${CMAKE_COMMAND} --install ${SCRATCH}/build --prefix ${prefix})

find_program(READELF readelf REQUIRED)
find_program(NM nm REQUIRED)
file(STRINGS ${SCRATCH}/build/CMakeCache.txt version REGEX "^CMAKE_PROJECT_VERSION:")
string(REGEX REPLACE ".*=" "" version ${version})
string(REGEX REPLACE "\\.[0-9]+$" "" abi ${version})
foreach(library ltl automata)
  file(GLOB_RECURSE found ${prefix}/libwaymark_${library}.so.${version})
  run(${READELF} -d ${found})
  if(NOT said MATCHES "SONAME.*\\[libwaymark_${library}\\.so\\.${abi}\\]")
    message(FATAL_ERROR "the name of ${found} is not libwaymark_${library}.so.${abi}")
  endif()
  run(${NM} -D --defined-only ${found})
  string(REGEX MATCHALL "[^\n]+" symbols "${said}")
  list(LENGTH symbols count)
  list(FILTER symbols EXCLUDE REGEX " (_Z(N|NK|NR|NO|NKR|TVN|TIN|TSN|TTN|GVN)|_ZThn[0-9]+_NK?)7waymark")
  if(symbols OR count LESS 100)
    message(FATAL_ERROR "${found} exports ${count} symbols, and these are not of waymark: ${symbols}")
  endif()
endforeach()

file(WRITE ${SCRATCH}/consumer/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(waymark REQUIRED COMPONENTS ltl automata)
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE waymark::automata)\n")
# An exception of the library is caught by its type, which both sides know.
file(WRITE ${SCRATCH}/consumer/main.cpp "#include <iostream>

#include \"libautomata/finite/ltlf_to_dfa.hpp\"
#include \"libltl/diagnostic.hpp\"
#include \"libltl/text/parse.hpp\"

int main() {
  waymark::ltl::Arena arena;
  std::cout << waymark::automata::ltlf_to_dfa(waymark::ltl::parse(\"F a\", arena)).states() << ' ';
  try {
    waymark::ltl::parse(\"F (\", arena);
  } catch (const waymark::ltl::SyntaxError&) {
    std::cout << \"caught\\n\";
  }
}\n")
run(${CMAKE_COMMAND} -S ${SCRATCH}/consumer -B ${SCRATCH}/consumer-build -G ${GENERATOR} ${none}
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${COMPILER})
run(${CMAKE_COMMAND} --build ${SCRATCH}/consumer-build)
run(${SCRATCH}/consumer-build/consumer)
if(NOT said STREQUAL "2 caught\n")
  message(FATAL_ERROR "the consumer printed '${said}'")
endif()

find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE pc ${prefix}/waymark-automata.pc)
  get_filename_component(pc ${pc} DIRECTORY)
  run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pc} ${PKG_CONFIG} --cflags --libs waymark-automata)
  separate_arguments(options UNIX_COMMAND "${said}")
  run(${COMPILER} ${SCRATCH}/consumer/main.cpp -o ${SCRATCH}/by-pkg-config ${options})
  get_filename_component(folder ${pc} DIRECTORY)
  run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${folder} ${SCRATCH}/by-pkg-config)
  if(NOT said STREQUAL "2 caught\n")
    message(FATAL_ERROR "the consumer by pkg-config printed '${said}'")
  endif()
else()
  message(STATUS "SKIPPED: pkg-config is not installed")
endif()

# The package of the shared libraries is named by their ABI, and other packages learn from it what to depend on.
find_program(DPKG_DEB dpkg-deb)
if(DPKG_DEB)
  run(${CMAKE_CPACK_COMMAND} --config ${SCRATCH}/build/CPackConfig.cmake -G DEB -B ${SCRATCH}/packages)
  file(GLOB libraries ${SCRATCH}/packages/libwaymark${abi}_*.deb)
  file(GLOB development ${SCRATCH}/packages/libwaymark-dev_*.deb)
  run(${DPKG_DEB} -e ${libraries} ${SCRATCH}/control)
  file(READ ${SCRATCH}/control/shlibs shlibs)
  if(NOT shlibs MATCHES "libwaymark_automata ${abi} libwaymark${abi} ")
    message(FATAL_ERROR "shlibs: ${shlibs}")
  endif()
  run(${DPKG_DEB} -f ${development} Depends)
  if(NOT said MATCHES "libwaymark${abi} \\(= ${version}\\)")
    message(FATAL_ERROR "libwaymark-dev depends on: ${said}")
  endif()
  find_program(LINTIAN lintian)
  if(LINTIAN)
    run(${LINTIAN} --allow-root --fail-on error ${libraries} ${development})
  else()
    message(STATUS "SKIPPED: lintian is not installed")
  endif()
else()
  message(STATUS "SKIPPED: this is no Debian")
endif()
