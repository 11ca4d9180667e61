# How our own targets are made. One place says how our code is compiled; it is linked
# PRIVATE, so a project that uses Rocinante does not inherit our warnings.

add_library(rocinante_build INTERFACE)
target_compile_options(rocinante_build INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  # Kinematics and pictures must come out with the same bits on every CPU (docs/decisions/003).
  -ffp-contract=off
  # Nobody replaces our functions at load time, so one may be inlined into another although the
  # libraries are position independent. What clang does anyway.
  $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>
  # g++ 12 sees overlaps in `"a" + std::string` that are not there (GCC 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${ROCINANTE_WERROR}>:-Werror>)

# A library that a program calls nothing of is not loaded with it: half of the time to start one that
# does little.
target_link_options(rocinante_build INTERFACE LINKER:--as-needed)

find_program(ROCINANTE_CCACHE ccache)
if(ROCINANTE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers (of the tests) are cached too, given these allowances. What g++ makes of a
  # piece in one checkout is what it would make in another; clang's precompiled headers name folders.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    list(APPEND CMAKE_CXX_COMPILER_LAUNCHER CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1)
  endif()
  list(APPEND CMAKE_CXX_COMPILER_LAUNCHER ${ROCINANTE_CCACHE})
endif()

# Many files at once cost two fifths of what they cost one by one, and most of a build is headers;
# who changes one file again and again leaves it off. The presets say ON.
option(ROCINANTE_UNITY "Compile each target's files in a few pieces" OFF)
set(ROCINANTE_UNITY_BATCH 24 CACHE STRING "Files in each piece: fewer rebuild sooner, more build sooner")
function(rocinante_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${ROCINANTE_UNITY}
    UNITY_BUILD_BATCH_SIZE ${ROCINANTE_UNITY_BATCH})
  if(ROCINANTE_UNITY)
    # A class of one .cpp may well hold what that .cpp keeps to itself: g++ takes it for a header.
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# What runs once in a command, or once in a frame that a person looks at: two thirds of the compiler's
# time when optimised, half of it under the sanitizers.
function(rocinante_seldom_run target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1> $<$<CONFIG:Debug>:-O0>)
endfunction()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)

# rocinante_library(packet SOURCES a.cpp PUBLIC_HEADERS a.h HEADERS b.h LINK rocinante_base
#   PRIVATE_LINK fmt::fmt [COMPONENT name] [SELDOM_RUN])
# makes rocinante_packet. Headers are included from the project root ("core/packet/packet.h").
# Public ones are installed (<rocinante/packet.h>), and their library with them, as component `packet`
# or COMPONENT: rocinante_install.cmake. A library with neither is not installed. Said again with that name,
# in another folder, it adds to the library: a small one costs the headers that it includes.
function(rocinante_library name)
  cmake_parse_arguments(arg "SELDOM_RUN" "COMPONENT" "SOURCES;HEADERS;PUBLIC_HEADERS;LINK;PRIVATE_LINK" ${ARGN})
  set(target rocinante_${name})
  if(TARGET ${target})
    target_sources(${target} PRIVATE ${arg_SOURCES})
  else()
    add_library(${target} STATIC ${arg_SOURCES})
  endif()
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_sources(${target} PRIVATE FILE_SET rocinante_headers TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
    FILES ${arg_PUBLIC_HEADERS} ${arg_HEADERS})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set(compiled_in ${arg_PRIVATE_LINK})
  list(FILTER compiled_in INCLUDE REGEX "^nlohmann_json::")
  list(REMOVE_ITEM arg_PRIVATE_LINK ${compiled_in} _)
  target_link_libraries(${target} PUBLIC ${arg_LINK}
    PRIVATE $<BUILD_INTERFACE:rocinante_build> ${arg_PRIVATE_LINK} "$<BUILD_INTERFACE:${compiled_in}>")
  rocinante_unity(${target})
  if(arg_SELDOM_RUN)
    rocinante_seldom_run(${target})
  endif()
  if(arg_PUBLIC_HEADERS OR arg_COMPONENT)
    if(NOT arg_COMPONENT)
      set(arg_COMPONENT ${name})
    endif()
    rocinante_export(${target} ${arg_COMPONENT} "${arg_PUBLIC_HEADERS}" "${arg_LINK};${arg_PRIVATE_LINK}")
  endif()
endfunction()

# Where modules are installed (core/base/loaded_module.h), and the way there from the programs.
set(ROCINANTE_MODULE_FOLDER ${CMAKE_INSTALL_LIBDIR}/rocinante)
file(RELATIVE_PATH ROCINANTE_MODULE_FROM_PROGRAMS
  /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${ROCINANTE_MODULE_FOLDER})

# rocinante_module(sdformat SOURCES a.cpp LINK b USED_BY rocinante_cell): lib/librocinante_sdformat.so.
# Nothing links a module, so whoever links the library that uses it must have it built.
function(rocinante_module name)
  cmake_parse_arguments(arg "" "USED_BY" "SOURCES;LINK" ${ARGN})
  set(target rocinante_${name})
  add_library(${target} MODULE ${arg_SOURCES})
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${target} PRIVATE ${arg_LINK} rocinante_build)
  set_target_properties(${target} PROPERTIES
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  add_dependencies(${arg_USED_BY} ${target})
  install(TARGETS ${target} LIBRARY DESTINATION ${ROCINANTE_MODULE_FOLDER} COMPONENT ${name})
endfunction()

# `cmake --build --preset release --target programs`: the programs without the tests.
add_custom_target(programs)

# rocinante_program(record SOURCES record_main.cpp LINK rocinante_recorder [COMPONENT view])
# makes bin/rocinante-record, of the component `programs` unless it says another.
function(rocinante_program name)
  cmake_parse_arguments(arg "" "COMPONENT" "SOURCES;LINK" ${ARGN})
  if(NOT arg_COMPONENT)
    set(arg_COMPONENT programs)
  endif()
  set(target rocinante-${name})
  add_executable(${target} ${arg_SOURCES})
  if(arg_COMPONENT STREQUAL programs)
    rocinante_share_code(${target} ${arg_LINK} rocinante_cli)
  endif()
  target_link_libraries(${target} PRIVATE ${arg_LINK} rocinante_cli rocinante_build)
  rocinante_unity(${target})
  # A main only parses arguments, with a library that takes long to optimise.
  rocinante_seldom_run(${target})
  add_dependencies(programs ${target})
  install(TARGETS ${target} COMPONENT ${arg_COMPONENT})
  rocinante_man_pages(${target} ${arg_COMPONENT})
endfunction()
