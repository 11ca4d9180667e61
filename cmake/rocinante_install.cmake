# What other projects use of Rocinante: public headers, archives, a CMake package with components and
# one pkg-config file for each component. All of it is the install component `dev`.
# docs/library.md describes it, docs/decisions/011 argues it.

# Public headers are included by one name wherever they lie in the tree: <rocinante/packet.h>.
# Installing them rewrites their includes; cmake/install_headers.cmake refuses a private one.
set(ROCINANTE_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/rocinante)
set(ROCINANTE_PKGCONFIG_FOLDER ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# Libraries that ours need when they are linked: target, how CMake finds it, what pkg-config calls it,
# and Debian.
set(rocinante_linked
  "fmt::fmt|package fmt|fmt|libfmt-dev"
  "glm::glm|package glm||libglm-dev"
  "tl::expected|package tl-expected||libexpected-dev"
  "tinyxml2::tinyxml2|package tinyxml2|tinyxml2|libtinyxml2-dev"
  "Threads::Threads|package Threads||"
  "ZLIB::ZLIB|package ZLIB|zlib|zlib1g-dev"
  "PkgConfig::ROCINANTE_ISAL|module libisal|libisal|libisal-dev"
  "PkgConfig::ROCINANTE_LIBSPNG|module spng|spng|libspng-dev"
  "PkgConfig::ROCINANTE_LIBLZ4|module liblz4|liblz4|liblz4-dev"
  "PkgConfig::ROCINANTE_SODIUM|module libsodium|libsodium|libsodium-dev"
  "PkgConfig::ROCINANTE_XXHASH|module libxxhash|libxxhash|libxxhash-dev"
  "PkgConfig::ROCINANTE_ZSTD|module libzstd|libzstd|libzstd-dev")
# Called by rocinante_library() for a library with public headers.
function(rocinante_export target component headers links)
  list(TRANSFORM headers PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  set_property(GLOBAL APPEND PROPERTY ROCINANTE_PUBLIC_HEADERS ${headers})
  set_property(GLOBAL APPEND PROPERTY ROCINANTE_COMPONENTS ${component})
  set_property(GLOBAL PROPERTY ROCINANTE_COMPONENT_OF_${target} ${component})

  set(needs)
  set(finds)
  set(requires)
  set(libs "-l${target}")
  foreach(link ${links})
    if(link MATCHES "^rocinante_")
      get_property(needed GLOBAL PROPERTY ROCINANTE_COMPONENT_OF_${link})
      if(NOT needed)
        message(FATAL_ERROR "${target} has public headers and links ${link}, which is not installed")
      endif()
      list(APPEND needs ${needed})
      list(APPEND requires "rocinante-${needed}")
    elseif(link STREQUAL CMAKE_DL_LIBS)
      string(APPEND libs " -l${link}")
    else()
      set(row ${rocinante_linked})
      list(FILTER row INCLUDE REGEX "^${link}\\|")
      if(NOT row)
        message(FATAL_ERROR "${target} has public headers and links ${link}: add it to rocinante_linked "
          "(cmake/rocinante_install.cmake)")
      endif()
      string(REGEX REPLACE ".*\\|" "" debian "${row}")
      set_property(GLOBAL APPEND PROPERTY ROCINANTE_DEV_PACKAGES ${debian})
      string(REGEX REPLACE "\\|[^|]*$" "" row "${row}")
      list(APPEND finds "${row}")
      string(REGEX REPLACE ".*\\|" "" module "${row}")
      list(APPEND requires ${module})
      if(link STREQUAL "Threads::Threads")
        string(APPEND libs " -pthread")
      endif()
    endif()
  endforeach()
  set_property(GLOBAL APPEND_STRING PROPERTY ROCINANTE_COMPONENT_TABLE
    "set(rocinante_needs_${component} \"${needs}\")\nset(rocinante_finds_${component} \"${finds}\")\n")

  add_library(rocinante::${component} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${component})
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(NOT PROJECT_IS_TOP_LEVEL)
    # Another project that has this one in a folder of its own includes by the same names.
    target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>)
    foreach(header ${headers})
      cmake_path(GET header FILENAME name)
      cmake_path(RELATIVE_PATH header BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
      file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/include/rocinante/${name}
        CONTENT "#include \"${header}\"\n")
    endforeach()
  endif()
  install(TARGETS ${target} EXPORT rocinante-${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
  install(EXPORT rocinante-${component} NAMESPACE rocinante:: FILE rocinante-${component}-targets.cmake
    DESTINATION ${ROCINANTE_PACKAGE_FOLDER} COMPONENT dev)

  # Only archives are installed, so what they need is no private matter of theirs.
  list(JOIN requires " " requires)
  file(RELATIVE_PATH prefix /prefix/${ROCINANTE_PKGCONFIG_FOLDER} /prefix)
  string(REGEX REPLACE "/$" "" prefix "${prefix}")
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/pkgconfig/rocinante-${component}.pc @ONLY CONTENT
"prefix=\${pcfiledir}/@prefix@
includedir=\${prefix}/@CMAKE_INSTALL_INCLUDEDIR@
libdir=\${prefix}/@CMAKE_INSTALL_LIBDIR@

Name: rocinante-@component@
Description: Rocinante's library: component @component@
Version: @PROJECT_VERSION@
Requires: @requires@
Cflags: -I\${includedir}
Libs: -L\${libdir} @libs@
")
  install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/rocinante-${component}.pc
    DESTINATION ${ROCINANTE_PKGCONFIG_FOLDER} COMPONENT dev)
endfunction()

# Called once, when all libraries are known.
function(rocinante_install_package)
  get_property(headers GLOBAL PROPERTY ROCINANTE_PUBLIC_HEADERS)
  install(CODE "set(rocinante_source \"${PROJECT_SOURCE_DIR}\")
    set(rocinante_staging \"${PROJECT_BINARY_DIR}/public-headers\")
    set(rocinante_destination \"${CMAKE_INSTALL_INCLUDEDIR}/rocinante\")
    set(rocinante_headers \"${headers}\")" COMPONENT dev)
  install(SCRIPT ${PROJECT_SOURCE_DIR}/cmake/install_headers.cmake COMPONENT dev)

  get_property(rocinante_components GLOBAL PROPERTY ROCINANTE_COMPONENTS)
  get_property(rocinante_component_table GLOBAL PROPERTY ROCINANTE_COMPONENT_TABLE)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/rocinante-config.cmake.in
    ${PROJECT_BINARY_DIR}/package/rocinante-config.cmake @ONLY)
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/rocinante-config-version.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/package/rocinante-config.cmake
    ${PROJECT_BINARY_DIR}/package/rocinante-config-version.cmake
    ${PROJECT_SOURCE_DIR}/cmake/rocinante_golden_test.cmake
    DESTINATION ${ROCINANTE_PACKAGE_FOLDER} COMPONENT dev)
endfunction()
