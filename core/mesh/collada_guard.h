#pragma once

#include <string>

#include "core/base/bytes.h"

namespace rocinante {

// assimp trusts the files that it reads. This keeps files from it that would crash the program or
// fill the memory. For glTF: core/mesh/gltf_guard.h.

/// Why a COLLADA file is refused: nodes that contain themselves, nesting that would overflow the
/// stack, a shape that is repeated a million times, numbers read that an array lacks. Empty when
/// there is no reason.
std::string problemOfCollada(ByteView bytes);

/// The `<up_axis>` of a COLLADA file: 'X', 'Y' (also the default) or 'Z'.
char upAxisOfCollada(ByteView bytes);

}  // namespace rocinante
