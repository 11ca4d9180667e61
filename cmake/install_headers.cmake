# Installs the public headers as <rocinante/NAME.h>: their includes of each other are rewritten, line
# for line. Fails when one includes a header that is not public, or two have one name.
cmake_policy(VERSION 3.25)
set(rocinante_names)
foreach(header IN LISTS rocinante_headers)
  cmake_path(GET header FILENAME name)
  if(name IN_LIST rocinante_names)
    message(FATAL_ERROR "two public headers are called ${name}")
  endif()
  list(APPEND rocinante_names ${name})
endforeach()

file(REMOVE_RECURSE "${rocinante_staging}")
foreach(header IN LISTS rocinante_headers)
  cmake_path(GET header FILENAME name)
  file(READ "${header}" text)
  string(REGEX MATCHALL "#include \"[^\"\n]*\"" includes "${text}")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "#include \"(.*)\"" "\\1" included "${include}")
    if(NOT "${rocinante_source}/${included}" IN_LIST rocinante_headers)
      message(FATAL_ERROR "${header} is a public header and includes ${included}, which is private")
    endif()
  endforeach()
  string(REGEX REPLACE "#include \"([^\"\n]*/)?([^\"/\n]*)\"" "#include <rocinante/\\2>" text "${text}")
  file(WRITE "${rocinante_staging}/${name}" "${text}")
endforeach()
# As a whole, so that a header of an earlier version does not stay behind unseen in the staging folder.
file(INSTALL "${rocinante_staging}/" DESTINATION "${CMAKE_INSTALL_PREFIX}/${rocinante_destination}"
  TYPE DIRECTORY FILES_MATCHING PATTERN "*.h")
