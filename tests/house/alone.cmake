# Of the scratch project: sources are checked, not compiled to code, and the library is an empty file.
include(WaymarkSettings)
set(CMAKE_OPTIMIZE_DEPENDENCIES ON)  # a static library does not wait for those below it
set(CMAKE_CXX_COMPILE_OBJECT
  "<CMAKE_CXX_COMPILER> <DEFINES> <INCLUDES> <FLAGS> -fsyntax-only <SOURCE>"
  "${CMAKE_COMMAND} -E touch <OBJECT>")
set(CMAKE_CXX_ARCHIVE_CREATE "${CMAKE_COMMAND} -E touch <TARGET>")
set(CMAKE_CXX_ARCHIVE_FINISH "${CMAKE_COMMAND} -E touch <TARGET>")
