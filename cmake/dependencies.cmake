# Libraries that more than one folder links, found once, here, so that every folder sees them.
# Everything is a Debian 12 package (scripts/packages.txt).
find_package(PkgConfig REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(tl-expected REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(Threads REQUIRED)
pkg_check_modules(ROCINANTE_ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(ROCINANTE_SODIUM REQUIRED IMPORTED_TARGET libsodium)
pkg_check_modules(ROCINANTE_XXHASH REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(ROCINANTE_TOMLPLUSPLUS REQUIRED IMPORTED_TARGET tomlplusplus)
