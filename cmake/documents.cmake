# The manual page and the completions for shells: the program writes them from its own tables, the build installs them.
set(documents ${PROJECT_BINARY_DIR}/documents)
file(MAKE_DIRECTORY ${documents})
set(made)
foreach(kind man bash zsh fish)
  add_custom_command(OUTPUT ${documents}/homolog.${kind} COMMAND homolog_cli generate ${kind} > ${documents}/homolog.${kind}
    DEPENDS homolog_cli VERBATIM)
  list(APPEND made ${documents}/homolog.${kind})
endforeach()
add_custom_target(documents ALL DEPENDS ${made})

install(FILES ${documents}/homolog.man DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME homolog.1 COMPONENT program)
install(FILES ${documents}/homolog.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME homolog COMPONENT program)
install(FILES ${documents}/homolog.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
# zsh looks in site-functions; but what Debian's packages put under /usr it seeks in a folder of its own.
install(CODE "
  set(folder site-functions)
  if(CMAKE_INSTALL_PREFIX MATCHES \"/usr$\")
    set(folder vendor-completions)
  endif()
  file(INSTALL \"${documents}/homolog.zsh\" DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/zsh/\${folder}\" RENAME _homolog)" COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)
install(FILES CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
