# cmake --install of the command line: the program, its helpers, its files for shells, and the data that it looks up.
# What shells and manuals know of the command line is written by the command line itself.
set(shell ${PROJECT_BINARY_DIR}/shell)
add_custom_command(OUTPUT ${shell}/man1/waymark.1.gz
  COMMAND waymark --write-shell-files ${shell}
  COMMAND sh -c "rm -f man1/*.gz && gzip -9n man1/*.1"
  DEPENDS waymark WORKING_DIRECTORY ${shell} VERBATIM)
file(MAKE_DIRECTORY ${shell})
add_custom_target(waymark_shell_files ALL DEPENDS ${shell}/man1/waymark.1.gz)
install(DIRECTORY ${shell}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT tools)
install(FILES ${shell}/bash/waymark DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tools)
install(FILES ${shell}/zsh/_waymark DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT tools)
install(FILES ${shell}/fish/waymark.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
  COMPONENT tools)

install(TARGETS waymark RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
foreach(helper lab layout convert serve)
  if(TARGET waymark-${helper})
    install(TARGETS waymark-${helper} RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/waymark COMPONENT tools)
  endif()
endforeach()
if(TARGET waymark-farm)  # a package of its own: nobody gets MPI who does not ask for it
  install(TARGETS waymark-farm RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/waymark COMPONENT farm)
endif()
if(TARGET waymark-distributed)  # the same of PETSc
  install(TARGETS waymark-distributed RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/waymark COMPONENT distributed)
endif()
install(DIRECTORY data/maps data/models data/words data/language data/schemas data/workspaces
                  data/experiments
  DESTINATION ${CMAKE_INSTALL_DATADIR}/waymark COMPONENT tools
  PATTERN fetch EXCLUDE PATTERN wordings EXCLUDE)  # what models are learned from is in the source
