# Man pages, by help2man from each program's --help (cmake/make_man_pages). Optional: without help2man
# there are none, and the configuration says so.
find_program(ROCINANTE_HELP2MAN help2man DOC "Writes the man pages")
find_program(ROCINANTE_PYTHON python3)
if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
  message(STATUS "man pages: left out, the programs do not run here (CMAKE_CROSSCOMPILING_EMULATOR)")
elseif(NOT ROCINANTE_HELP2MAN OR NOT ROCINANTE_PYTHON)
  message(STATUS "man pages: left out, there is no help2man or no python3")
else()
  set(ROCINANTE_MAN_PAGES ON)
endif()
add_custom_target(man_pages)

# rocinante_man_pages(rocinante-log programs): the pages of this program and of its subcommands, written
# when it is built and installed with the component.
function(rocinante_man_pages program component)
  if(NOT ROCINANTE_MAN_PAGES)
    return()
  endif()
  set(pages ${PROJECT_BINARY_DIR}/man/${program})
  # rocinante-golden-compare may be a subcommand of rocinante-golden, which is asked.
  string(REGEX REPLACE "-[^-]*$" "" parent ${program})
  if(NOT TARGET ${parent})
    set(parent)
  endif()
  # The names and what they are for are told by `rocinante`.
  add_custom_command(OUTPUT ${pages}.made
    COMMAND ${ROCINANTE_PYTHON} ${PROJECT_SOURCE_DIR}/cmake/make_man_pages ${PROJECT_BINARY_DIR}/bin ${program}
      ${pages} ${PROJECT_VERSION} ${CMAKE_INSTALL_PREFIX} ${CMAKE_CROSSCOMPILING_EMULATOR}
    COMMAND ${CMAKE_COMMAND} -E touch ${pages}.made
    DEPENDS ${program} rocinante ${parent} ${PROJECT_SOURCE_DIR}/cmake/make_man_pages
    COMMENT "Man pages of ${program}" VERBATIM)
  add_custom_target(${program}_man_pages ALL DEPENDS ${pages}.made)
  add_dependencies(man_pages ${program}_man_pages)
  # Who builds the programs alone installs them too (scripts/demo, cmake --install).
  add_dependencies(programs ${program}_man_pages)
  install(DIRECTORY ${pages}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
endfunction()
