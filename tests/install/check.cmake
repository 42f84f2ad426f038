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

# The installed waymark finds its maps, its model and its helper without being told where they are.
run(${CMAKE_COMMAND} -E env --unset=WAYMARK_DATA ${prefix}/bin/waymark run "walk forward" --map grid --start 1,9,0 --svg ${SCRATCH}/route.svg)
if(NOT EXISTS ${SCRATCH}/route.svg)
  message(FATAL_ERROR "the installed waymark drew nothing")
endif()
