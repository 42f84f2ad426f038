# README.md shows what the demo prints, its last line, the time, aside. `./dev docs` brings it up to date.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${WAYMARK} run --demo OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "\ntime .*" "\n" said "${said}")
file(READ ${README} readme)
string(FIND "${readme}" "<!-- demo -->\n```\n${said}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "README.md does not show the demo as it is now (./dev docs):\n${said}")
endif()
