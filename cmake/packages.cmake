# Debian packages by CPack, one a component (scripts/package, docs/installing.md). Nothing here takes
# part in building; `cpack -G DEB` in a build folder that was configured with the prefix /usr makes them.
find_program(ROCINANTE_DPKG dpkg)
if(NOT ROCINANTE_DPKG)
  return()
endif()

# 0.1.0-1~deb12, ~deb13, ~debforky ...: whoever goes to the next Debian gets the package made for it.
file(STRINGS /etc/os-release os_release)
foreach(line ${os_release})
  if(line MATCHES "^(ID|VERSION_ID|VERSION_CODENAME)=\"?([^\"]*)\"?$")
    set(os_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  endif()
endforeach()
string(REPLACE debian deb os_ID "${os_ID}")
if(NOT os_VERSION_ID)
  set(os_VERSION_ID ${os_VERSION_CODENAME})
endif()
set(ROCINANTE_PACKAGE_MAINTAINER "The Rocinante authors <authors@rocinante.example>" CACHE STRING
  "Whom the packages name as maintainer")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rocinante)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT ${ROCINANTE_PACKAGE_MAINTAINER})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "1~${os_ID}${os_VERSION_ID}")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_DEBUGINFO_PACKAGE ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
  GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package_staging.cmake)
set(CPACK_OBJCOPY_EXECUTABLE ${CMAKE_OBJCOPY})
set(CPACK_READELF_EXECUTABLE ${CMAKE_READELF})
set(CPACK_ROCINANTE_STRIP ${CMAKE_STRIP})
if(CMAKE_CROSSCOMPILING)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -dumpmachine OUTPUT_VARIABLE machine OUTPUT_STRIP_TRAILING_WHITESPACE)
  execute_process(COMMAND dpkg-architecture -f -t ${machine} -q DEB_HOST_ARCH
    OUTPUT_VARIABLE CPACK_DEBIAN_PACKAGE_ARCHITECTURE OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
set(CPACK_COMPONENTS_ALL programs dev)
set(same_version "(= ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

# rocinante_package(view rocinante-view SECTION utils SUMMARY "..." TEXT "..." [DEPENDS ...] [RECOMMENDS ...]
#   [SUGGESTS ...] [COMPILED_IN fonts-dejavu-core...])
# DEPENDS: beyond the libraries that its files are linked with. COMPILED_IN: the packages whose code or
# data lies within its files; their terms go into its copyright file.
function(rocinante_package component name)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "SECTION;SUMMARY;TEXT;DEPENDS;RECOMMENDS;SUGGESTS" "COMPILED_IN")
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${arg_SECTION} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${arg_SUMMARY}\n${arg_TEXT}" PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${arg_SUMMARY}\n${arg_TEXT}" PARENT_SCOPE)
  foreach(field DEPENDS RECOMMENDS SUGGESTS)
    if(arg_${field})
      set(CPACK_DEBIAN_${upper}_PACKAGE_${field} "${arg_${field}}" PARENT_SCOPE)
    endif()
  endforeach()

  set(papers ${PROJECT_BINARY_DIR}/package_papers/${name})
  file(READ ${PROJECT_SOURCE_DIR}/LICENSE ours)
  set(text "This is Rocinante, packaged by its authors.\n\n${ours}")
  foreach(package ${arg_COMPILED_IN})
    if(EXISTS /usr/share/doc/${package}/copyright)
      file(READ /usr/share/doc/${package}/copyright theirs)
      string(APPEND text "\n\nParts of what Debian calls ${package} are compiled in. Its copyright file says:\n\n${theirs}")
    endif()
  endforeach()
  file(WRITE ${papers}/copyright "${text}")
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE ${papers}/changelog.Debian "rocinante (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) \
${os_VERSION_CODENAME}; urgency=medium\n\n  * See /usr/share/doc/rocinante/CHANGELOG.md.\n\n \
-- ${ROCINANTE_PACKAGE_MAINTAINER}  ${date}\n")
  install(FILES ${papers}/copyright ${papers}/changelog.Debian DESTINATION share/doc/${name}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

# What draws is opened when it is first needed, so that nobody who only records must have it.
set(renderer "libegl1, libegl-mesa0")
if(ROCINANTE_OSMESA OR ROCINANTE_OSMESA_FOUND)
  set(renderer libosmesa6)
endif()
set(headers fonts-dejavu-core libcli11-dev libexpected-dev libfast-float-dev libglm-dev libtomlplusplus-dev
  nlohmann-json3-dev)
# The viewer of pages, where scripts/build_web made it (viewer/page/CMakeLists.txt).
set(viewer_headers ${headers})
if(EXISTS ${PROJECT_SOURCE_DIR}/build/web/bin/rocinante-viewer.wasm)
  list(APPEND viewer_headers emscripten libmeshoptimizer-dev libspng-dev libzstd-dev zlib1g-dev)
endif()
rocinante_package(programs rocinante SECTION utils
  RECOMMENDS "${renderer}"
  SUGGESTS "rocinante-view, rocinante-serve, rocinante-openimageio, rocinante-nats, rocinante-protobuf, rocinante-sdf, ffmpeg, git"
  COMPILED_IN ${viewer_headers}
  SUMMARY "record, replay and test streamed robot and simulator state"
  TEXT "Robots and simulators send poses and joint values as small text packets over
UDP. Rocinante records every datagram with its kernel time stamp to MCAP,
replays a log with exact timing, compares rendered frames with accepted
pictures, and checks a session against its model.
.
This package has the programs for a terminal and for CI. The window is in
rocinante-view; textures that are not PNG need rocinante-openimageio, models
in SDF rocinante-sdf, subjects and streams of a NATS server rocinante-nats,
decoders of protobuf messages rocinante-protobuf.
Drawing needs Mesa, which is recommended; recording, replaying and checking
do not.")
if(ROCINANTE_GL AND ROCINANTE_WINDOW)
  list(APPEND CPACK_COMPONENTS_ALL view)
  rocinante_package(view rocinante-view SECTION utils
    DEPENDS "rocinante ${same_version}"
    SUGGESTS rocinante-openimageio
    COMPILED_IN ${headers} libimgui-dev
    SUMMARY "interactive viewer of robot and simulator sessions"
    TEXT "Shows any moment of a recorded session, or what arrives now, in 3D, from URDF,
SDF, OBJ, STL, COLLADA or glTF.
.
This package has the window of Rocinante, its desktop entry included.")
endif()
if(ROCINANTE_SERVE)
  list(APPEND CPACK_COMPONENTS_ALL serve)
  rocinante_package(serve rocinante-serve SECTION utils
    DEPENDS "rocinante ${same_version}"
    COMPILED_IN ${headers}
    SUMMARY "shows Rocinante's sessions in any browser of the network"
    TEXT "Serves the page of rocinante-page over HTTP, with a recorded session or
with what comes live, and speaks the protocol of Foxglove and Lichtblick,
by libwebsockets.")
endif()
if(ROCINANTE_OPENIMAGEIO)
  list(APPEND CPACK_COMPONENTS_ALL openimageio)
  rocinante_package(openimageio rocinante-openimageio SECTION utils
    DEPENDS "rocinante ${same_version}"
    SUMMARY "lets Rocinante read textures in JPEG, TIFF, EXR and more"
    TEXT "Rocinante reads PNG by itself. This module reads the other formats, by
OpenImageIO.
.
It is a package of its own because OpenImageIO needs half a gigabyte.")
endif()
if(ROCINANTE_NATS)
  list(APPEND CPACK_COMPONENTS_ALL nats_client)
  rocinante_package(nats_client rocinante-nats SECTION utils
    DEPENDS "rocinante ${same_version}"
    SUMMARY "lets Rocinante receive from and send to a NATS server"
    TEXT "Rocinante listens and sends by UDP. This module connects it to the subjects of
a NATS server (nats://) and records the streams that one keeps
(jetstream://), by libnats.")
endif()
if(ROCINANTE_PROTOBUF)
  list(APPEND CPACK_COMPONENTS_ALL protobuf_messages)
  rocinante_package(protobuf_messages rocinante-protobuf SECTION utils
    DEPENDS "rocinante ${same_version}"
    SUMMARY "lets Rocinante decode protobuf messages"
    TEXT "Rocinante decodes datagrams of robots by a declaration: binary, XML, JSON, text
and DIS by itself. This module reads protobuf messages by a descriptor file, by
libprotobuf.")
endif()
if(ROCINANTE_SDF)
  list(APPEND CPACK_COMPONENTS_ALL sdformat)
  rocinante_package(sdformat rocinante-sdf SECTION utils
    DEPENDS "rocinante ${same_version}"
    SUMMARY "lets Rocinante read models in SDF"
    TEXT "Rocinante reads URDF, OBJ, STL, COLLADA and glTF by itself. This module reads
models in SDF, by libsdformat.")
endif()
list(APPEND CPACK_COMPONENTS_ALL python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
rocinante_package(python python3-rocinante SECTION python
  DEPENDS "rocinante (>= ${CPACK_PACKAGE_VERSION}), python3 (>= 3.9), python3-numpy"
  SUGGESTS python3-pytest
  SUMMARY "sessions of robots and simulators in Python"
  TEXT "Recorded sessions as NumPy arrays, frames as arrays and pictures of a notebook,
recorders and players as context managers, a source of state, and a plugin of
pytest that judges pictures and sessions against accepted ones.")
# What the installed archives link (rocinante_install.cmake).
get_property(needed GLOBAL PROPERTY ROCINANTE_DEV_PACKAGES)
list(REMOVE_DUPLICATES needed)
list(SORT needed)
list(JOIN needed ", " needed)
rocinante_package(dev librocinante-dev SECTION libdevel
  DEPENDS "${needed}"
  RECOMMENDS "rocinante ${same_version}"
  COMPILED_IN ${headers}
  SUMMARY "libraries of Rocinante for C++ programs"
  SUGGESTS "cmake, pkgconf, libgmock-dev"
  TEXT "Rocinante records, replays and tests streamed robot and simulator state.
.
This package has the headers, the static libraries, the CMake package with its
components, and a pkg-config file for each.")
include(CPack)
