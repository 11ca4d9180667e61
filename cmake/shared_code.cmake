# What packages install: one library with the code of all programs, private to them, where each would
# hold a copy of its own (docs/installing.md). A build that is not packaged links each program alone:
# it starts sooner, and whoever changes one library relinks only what uses it.
option(ROCINANTE_SHARE_CODE "Programs load one private library in place of a copy of their code in each" OFF)
if(ROCINANTE_SHARE_CODE)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()

# rocinante_share_code(PROGRAM LIBRARIES...): called before PROGRAM is linked to LIBRARIES. The linker
# takes from an archive only what it has not found before it: first on the line, the shared library
# leaves nothing to take.
function(rocinante_share_code program)
  if(NOT ROCINANTE_SHARE_CODE)
    return()
  endif()
  list(FILTER ARGN INCLUDE REGEX "^rocinante_")
  set_property(GLOBAL APPEND PROPERTY ROCINANTE_SHARED ${ARGN})
  target_link_libraries(${program} PRIVATE rocinante_shared)
  set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/${ROCINANTE_MODULE_FROM_PROGRAMS}")
endfunction()

# After the last program: makes librocinante_shared.so of what they named, and of what that links.
function(rocinante_make_shared_code)
  if(NOT ROCINANTE_SHARE_CODE)
    return()
  endif()
  get_property(open GLOBAL PROPERTY ROCINANTE_SHARED)
  set(archives)
  while(open)
    list(POP_BACK open library)
    get_target_property(kind ${library} TYPE)
    if(library IN_LIST archives OR NOT kind STREQUAL STATIC_LIBRARY)
      continue()
    endif()
    list(APPEND archives ${library})
    get_target_property(links ${library} LINK_LIBRARIES)
    list(FILTER links INCLUDE REGEX "^rocinante_[a-z0-9_]+$")
    list(APPEND open ${links})
  endwhile()

  set(nothing ${PROJECT_BINARY_DIR}/shared_code.cpp)
  file(GENERATE OUTPUT ${nothing} CONTENT "")
  add_library(rocinante_shared SHARED ${nothing})
  list(JOIN archives ">;$<TARGET_FILE:" files)
  target_link_options(rocinante_shared PRIVATE LINKER:--whole-archive "$<TARGET_FILE:${files}>" LINKER:--no-whole-archive)
  target_link_libraries(rocinante_shared PRIVATE ${archives} rocinante_build)
  install(TARGETS rocinante_shared LIBRARY DESTINATION ${ROCINANTE_MODULE_FOLDER} COMPONENT programs)
endfunction()
