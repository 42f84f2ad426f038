# Configures WAYMARK with every option off, with the packages of these options out of sight; and a waymark without
# helpers says of each command that needs one how to get it.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SCRATCH})
set(off "")
foreach(option WAYMARK_TESTS WAYMARK_WITH_MPI WAYMARK_WITH_PETSC WAYMARK_WITH_OMPL WAYMARK_WITH_GRAPHVIZ WAYMARK_WITH_CAIRO WAYMARK_WITH_STUDIO
               WAYMARK_WITH_PYTHON)
  list(APPEND off -D${option}=OFF)
endforeach()
foreach(package PkgConfig MPI ompl GTest Python pybind11)
  list(APPEND off -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WAYMARK} -B ${SCRATCH}/build -G ${GENERATOR} ${off}
  -DCMAKE_CXX_COMPILER=${COMPILER} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${SCRATCH}/build --target help OUTPUT_VARIABLE targets
  COMMAND_ERROR_IS_FATAL ANY)
if(NOT targets MATCHES "waymark-lab" OR targets MATCHES "waymark-(layout|convert|motion|serve|farm|distributed)|test_libltl")
  message(FATAL_ERROR "the build without options has these targets:\n${targets}")
endif()

file(COPY ${BIN}/waymark DESTINATION ${SCRATCH}/bin)
function(refused by)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env WAYMARK_DATA=${DATA} ${SCRATCH}/bin/waymark ${ARGN}
    OUTPUT_VARIABLE said ERROR_VARIABLE complaint RESULT_VARIABLE code)
  if(NOT code EQUAL 20 OR NOT complaint MATCHES "${by}.*is not built.*to build it: ")
    message(FATAL_ERROR "waymark ${ARGN}: exit code ${code}, ${complaint}")
  endif()
endfunction()
set(ENV{OMPI_COMM_WORLD_RANK} 0)  # as mpirun sets it
refused(waymark-farm translate "F a" --to dfa)
refused(waymark-distributed plan --case absent.json)
unset(ENV{OMPI_COMM_WORLD_RANK})
refused(waymark-motion move "F chair" --map grid --start 1,9,0)
refused(waymark-serve serve)
refused(waymark-lab experiment feedback-cost)
refused(waymark-convert draw --map grid --png ${SCRATCH}/grid.png)
refused(waymark-layout translate "F a" --to dfa --svg ${SCRATCH}/automaton.svg)
