# Optional parts. Each option is ON, OFF or AUTO: built where its libraries are. Configuring says what
# is left out; `rocinante --version --parts` lists them all, from the file that is written here.
# A variable ROCINANTE_X of every part is ON or OFF afterwards.
set(rocinante_part_rows "")

# rocinante_part(window ROCINANTE_WINDOW "rocinante-view" [NEEDS ROCINANTE_GL] [FILE rocinante-view]
#   [MODULES glfw3 PACKAGES libglfw3-dev])
# MODULES: of pkg-config, PACKAGES: Debian's that have them, in the same order. FILE: the program or
# module that the part lies in, when it has one of its own.
function(rocinante_part name option does)
  cmake_parse_arguments(PARSE_ARGV 3 part "" "NEEDS;FILE" "MODULES;PACKAGES")
  set(${option} AUTO CACHE STRING "Build ${does}: ON, OFF, or AUTO where its libraries are")
  set_property(CACHE ${option} PROPERTY STRINGS AUTO ON OFF)
  set(versions "")
  set(missing "")
  foreach(module package IN ZIP_LISTS part_MODULES part_PACKAGES)
    pkg_check_modules(ROCINANTE_PART_${module} QUIET ${module})
    if(ROCINANTE_PART_${module}_FOUND)
      list(APPEND versions "${module} ${ROCINANTE_PART_${module}_VERSION}")
    else()
      list(APPEND missing ${package})
    endif()
  endforeach()
  list(JOIN versions ", " versions)
  list(JOIN missing " and " missing)
  set(built OFF)
  if(part_NEEDS AND NOT ${part_NEEDS})
    set(detail "needs ${part_NEEDS}, which is off")
  elseif(${option} STREQUAL "AUTO" AND missing)
    set(detail "built without ${missing}")
  elseif(NOT ${option} STREQUAL "AUTO" AND NOT ${option})
    set(detail "switched off: ${option}=OFF")
  elseif(missing)
    message(FATAL_ERROR "${option} is ON, but its library is missing: install ${missing}, "
      "or configure with -D${option}=OFF")
  else()
    set(built ON)
    set(detail "${versions}")
  endif()
  set(truth true)
  if(NOT built)
    set(truth false)
    message(STATUS "rocinante: left out: ${name} (${does}): ${detail}")
  endif()
  set(rocinante_part_rows
    "${rocinante_part_rows}    {\"${name}\", \"${does}\", \"${part_FILE}\", ${truth}, \"${detail}\"},\n" PARENT_SCOPE)
  set(${option} ${built} PARENT_SCOPE)
endfunction()

find_package(PkgConfig REQUIRED)
rocinante_part(pictures ROCINANTE_GL "render and golden" FILE rocinante-render)
rocinante_part(osmesa ROCINANTE_OSMESA "drawing by OSMesa beside EGL" NEEDS ROCINANTE_GL
  MODULES osmesa PACKAGES libosmesa6-dev)
rocinante_part(window ROCINANTE_WINDOW "the interactive viewer" NEEDS ROCINANTE_GL FILE rocinante-view
  MODULES glfw3 imgui PACKAGES libglfw3-dev libimgui-dev)
rocinante_part(openimageio ROCINANTE_OPENIMAGEIO "reading JPEG, TIFF, EXR" NEEDS ROCINANTE_GL
  FILE librocinante_openimageio.so MODULES OpenImageIO PACKAGES libopenimageio-dev)
rocinante_part(pcap ROCINANTE_PCAP "pcap:// endpoints and captures"
  MODULES libpcap PACKAGES libpcap-dev)
rocinante_part(nats ROCINANTE_NATS "nats:// and jetstream:// endpoints"
  FILE librocinante_nats_client.so
  MODULES libnats PACKAGES libnats-dev)
rocinante_part(lz4 ROCINANTE_LZ4 "reading chunks that lz4 compressed"
  MODULES liblz4 PACKAGES liblz4-dev)
rocinante_part(sqlite ROCINANTE_SQLITE "reading ROS 2 bags of sqlite3"
  MODULES sqlite3 PACKAGES libsqlite3-dev)
# Debian 12 has no bzip2.pc: the part needs what CMake's own search finds.
find_package(BZip2 QUIET)
set(libbz2-dev ${BZIP2_FOUND})
rocinante_part(bzip2 ROCINANTE_BZIP2 "reading ROS 1 bags that bzip2 compressed" NEEDS libbz2-dev)
rocinante_part(serve ROCINANTE_SERVE "serving a session to browsers" NEEDS ROCINANTE_GL
  FILE rocinante-serve MODULES libwebsockets PACKAGES libwebsockets-dev)
rocinante_part(zip ROCINANTE_ZIP "approving pictures from a ZIP file of CI" NEEDS ROCINANTE_GL
  MODULES libzip PACKAGES libzip-dev)
rocinante_part(protobuf ROCINANTE_PROTOBUF "decoders of protobuf messages"
  FILE librocinante_protobuf_messages.so
  MODULES protobuf PACKAGES libprotobuf-dev)
rocinante_part(sdf ROCINANTE_SDF "reading SDF" FILE librocinante_sdformat.so
  MODULES sdformat12 console_bridge PACKAGES libsdformat-dev libconsole-bridge-dev)

set(ROCINANTE_PARTS_FILE ${PROJECT_BINARY_DIR}/build_parts.cpp)
file(GENERATE OUTPUT ${ROCINANTE_PARTS_FILE} CONTENT
"#include \"core/cli/parts_text.h\"

namespace rocinante {

const BuildPart kBuildParts[] = {
${rocinante_part_rows}};
const std::size_t kBuildPartCount = sizeof kBuildParts / sizeof kBuildParts[0];

}  // namespace rocinante
")
