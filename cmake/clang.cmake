# Toolchain file: the clang of this release, the first of those that scripts/packages.txt asks for.
find_program(ROCINANTE_CLANG NAMES clang++-14 clang++-19 clang++-22 clang++ REQUIRED)
set(CMAKE_CXX_COMPILER ${ROCINANTE_CLANG})
