include(${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/rocinante-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/rocinante_golden_test.cmake)
