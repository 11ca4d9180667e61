# What shells and desktops know of the programs: completions, the types of our files, an icon, and the
# entry that opens them in the viewer.
install(FILES completions/rocinante DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  COMPONENT programs)
install(FILES completions/_rocinante DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
  COMPONENT programs)
install(FILES completions/rocinante.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
  COMPONENT programs)
# bash-completion and fish load a file by the name of the command that is completed.
foreach(verb record spy play source relay log model check render view golden)
  foreach(link bash-completion/completions/rocinante-${verb}:rocinante
      fish/vendor_completions.d/rocinante-${verb}.fish:rocinante.fish)
    string(REGEX REPLACE ":.*" "" name ${link})
    string(REGEX REPLACE ".*:" "" target ${link})
    install(CODE "file(CREATE_LINK ${target}
      \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/${name}\" SYMBOLIC)" COMPONENT programs)
  endforeach()
endforeach()
install(FILES desktop/rocinante.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT programs)
install(FILES desktop/rocinante.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps
  COMPONENT programs)
if(ROCINANTE_WINDOW)
  install(FILES desktop/rocinante-view.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT view)
endif()
