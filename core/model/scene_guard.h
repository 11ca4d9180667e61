#pragma once

#include <string>

#include "core/bytes.h"
#include "core/result.h"

namespace rocinante {

// assimp trusts the files that it reads. What follows keeps from it those that would end the
// program or fill the memory.

/// What makes a COLLADA file unfit: nodes that contain themselves, nesting that would overflow the
/// stack, a shape that is repeated a million times, numbers read that an array lacks. A sentence;
/// empty when there is nothing.
std::string problemOfCollada(ByteView bytes);

/// A glTF file, text or binary, of the same kind without what is not drawn (skins, animations,
/// morph targets, cameras, extensions but for KHR_texture_transform). damaged when a number leads
/// out of what it counts, a length is more than there is, nodes do not form trees, or nesting is
/// deep; unsupported when it is no glTF 2 or requires an extension.
Result<Bytes> soundGltf(ByteView bytes);

/// The `<up_axis>` of a COLLADA file: 'X', 'Y' (also where it says none) or 'Z'.
char upAxisOfCollada(ByteView bytes);

}  // namespace rocinante
