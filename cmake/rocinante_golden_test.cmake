# rocinante_add_golden_test(NAME gripper SUITE goldens/gripper.suite.toml
#   [ONLY GLOB] [REPORT DIR] [LABELS label...])
# makes one test that runs `rocinante golden run SUITE`: it fails when a frame is different, missing
# or unstable, and when nothing could be judged. SUITE is relative to the current source folder. The
# report is DIR/index.html, with DIR/junit.xml and DIR/verdicts.json beside it; by default DIR is
# golden-reports/NAME in the current build folder. Labels: `golden` and those given.

# The program lies beside what this file was installed with, whatever the library folder is called.
find_program(ROCINANTE_PROGRAM rocinante
  HINTS ${CMAKE_CURRENT_LIST_DIR}/../../../bin ${CMAKE_CURRENT_LIST_DIR}/../../../../bin
  DOC "The program that golden tests run")

function(rocinante_add_golden_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;SUITE;ONLY;REPORT" "LABELS")
  if(NOT arg_NAME OR NOT arg_SUITE OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "rocinante_add_golden_test(NAME name SUITE file [ONLY glob] [REPORT dir] "
      "[LABELS label...]): got `${ARGV}`")
  endif()
  if(NOT ROCINANTE_PROGRAM)
    message(FATAL_ERROR "rocinante_add_golden_test: there is no program rocinante; "
      "set ROCINANTE_PROGRAM to its path")
  endif()
  cmake_path(ABSOLUTE_PATH arg_SUITE BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  if(NOT EXISTS ${arg_SUITE})
    message(FATAL_ERROR "rocinante_add_golden_test(NAME ${arg_NAME}): there is no ${arg_SUITE}")
  endif()
  if(NOT arg_REPORT)
    set(arg_REPORT golden-reports/${arg_NAME})
  endif()
  cmake_path(ABSOLUTE_PATH arg_REPORT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  file(MAKE_DIRECTORY ${arg_REPORT})
  set(only)
  if(arg_ONLY)
    set(only --only ${arg_ONLY})
  endif()
  add_test(NAME ${arg_NAME}
    COMMAND ${ROCINANTE_PROGRAM} golden run ${arg_SUITE} ${only} --report ${arg_REPORT}
      --junit ${arg_REPORT}/junit.xml --json ${arg_REPORT}/verdicts.json)
  set_tests_properties(${arg_NAME} PROPERTIES
    LABELS "golden;${arg_LABELS}"
    ATTACHED_FILES_ON_FAIL "${arg_REPORT}/index.html")
endfunction()
