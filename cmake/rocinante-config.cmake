# A project without C++ has suites to judge, and links nothing.
get_property(rocinante_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if(CXX IN_LIST rocinante_languages)
  include(${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)
  include(${CMAKE_CURRENT_LIST_DIR}/rocinante-targets.cmake)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/rocinante_golden_test.cmake)
