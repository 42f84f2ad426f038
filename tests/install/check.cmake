# Installs BUILD_DIR into SCRATCH, builds CONSUMER against it, runs both binaries from there.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SCRATCH})
set(prefix ${SCRATCH}/prefix)

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE said COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  set(said "${said}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/consumer ${prefix}/share/waymark)
if(NOT said STREQUAL "certified: LEFT LEFT FORWARD LEFT FORWARD\n")
  message(FATAL_ERROR "the consumer printed '${said}'")
endif()
execute_process(COMMAND ${SCRATCH}/build/consumer ${prefix}/share/waymark "F chiar" ERROR_VARIABLE said RESULT_VARIABLE code)
if(NOT code EQUAL 1 OR NOT said MATCHES "did you mean 'chair'")
  message(FATAL_ERROR "the consumer said of an unknown proposition: '${said}', exit ${code}")
endif()

# The same by components: formulas and automata need neither Boost nor Eigen, and a component that is not there is named.
set(find_ltl "cmake_minimum_required(VERSION 3.25)\nproject(parts LANGUAGES CXX)\n")
file(WRITE ${SCRATCH}/parts/CMakeLists.txt "${find_ltl}find_package(waymark 0.1 REQUIRED COMPONENTS ltl automata)
if(Boost_FOUND OR Eigen3_FOUND OR NOT waymark_ltl_FOUND OR NOT TARGET waymark::automata)
  message(FATAL_ERROR \"components: too much or too little was found\")
endif()\n")
run(${CMAKE_COMMAND} -S ${SCRATCH}/parts -B ${SCRATCH}/parts-build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_CXX_COMPILER=${COMPILER})
file(WRITE ${SCRATCH}/wrong/CMakeLists.txt "${find_ltl}find_package(waymark COMPONENTS ltl teleport)
if(waymark_FOUND)
  message(FATAL_ERROR \"the component teleport was found\")
endif()\n")
run(${CMAKE_COMMAND} -S ${SCRATCH}/wrong -B ${SCRATCH}/wrong-build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_CXX_COMPILER=${COMPILER})

# The same consumer by pkg-config.
find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE pc ${prefix}/waymark-parser.pc)
  get_filename_component(pc ${pc} DIRECTORY)
  run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pc} ${PKG_CONFIG} --cflags --libs waymark-parser)
  separate_arguments(options UNIX_COMMAND "${said}")
  separate_arguments(flags UNIX_COMMAND "${FLAGS}")
  run(${COMPILER} ${flags} ${CONSUMER}/main.cpp -o ${SCRATCH}/by-pkg-config ${options})
  run(${SCRATCH}/by-pkg-config ${prefix}/share/waymark)
  if(NOT said STREQUAL "certified: LEFT LEFT FORWARD LEFT FORWARD\n")
    message(FATAL_ERROR "the consumer by pkg-config printed '${said}'")
  endif()
else()
  message(STATUS "SKIPPED: pkg-config is not installed")
endif()

# The installed waymark finds its maps, its model and its helper without being told where they are.
run(${CMAKE_COMMAND} -E env --unset=WAYMARK_DATA ${prefix}/bin/waymark run "walk forward" --map grid --start 1,9,0 --svg ${SCRATCH}/route.svg)
if(NOT EXISTS ${SCRATCH}/route.svg)
  message(FATAL_ERROR "the installed waymark drew nothing")
endif()
