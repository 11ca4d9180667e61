#pragma once

#include <string>

#include "core/base/bytes.h"

namespace rocinante {

// assimp trusts the files that it reads. What follows keeps from it those that would end the
// program or fill the memory; for glTF, core/mesh/gltf_guard.h does.

/// What makes a COLLADA file unfit: nodes that contain themselves, nesting that would overflow the
/// stack, a shape that is repeated a million times, numbers read that an array lacks. A sentence;
/// empty when there is nothing.
std::string problemOfCollada(ByteView bytes);

/// The `<up_axis>` of a COLLADA file: 'X', 'Y' (also where it says none) or 'Z'.
char upAxisOfCollada(ByteView bytes);

}  // namespace rocinante
