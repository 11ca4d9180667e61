# Libraries that more than one folder links, found once, here, so that every folder sees them.
# Everything is a package of Debian 12, 13 and forky (scripts/packages.txt).
find_package(PkgConfig REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(tl-expected REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(tinyxml2 REQUIRED)
find_package(Threads REQUIRED)
pkg_check_modules(ROCINANTE_ISAL REQUIRED IMPORTED_TARGET libisal)
pkg_check_modules(ROCINANTE_ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(ROCINANTE_SODIUM REQUIRED IMPORTED_TARGET libsodium)
pkg_check_modules(ROCINANTE_XXHASH REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(ROCINANTE_TOMLPLUSPLUS REQUIRED IMPORTED_TARGET tomlplusplus)
# Not its CMake package, which asks for libraries that only its programs need.
pkg_check_modules(ROCINANTE_ASSIMP REQUIRED IMPORTED_TARGET assimp)
# Optional: a build with ROCINANTE_PCAP=OFF does not need it.
if(NOT DEFINED ROCINANTE_PCAP OR ROCINANTE_PCAP)
  pkg_check_modules(ROCINANTE_LIBPCAP IMPORTED_TARGET libpcap)
endif()
