#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

// Keeps from assimp what would end the program or fill the memory (for COLLADA:
// core/mesh/collada_guard.h).

/// A glTF file, text or binary, of the same kind without what is not drawn (skins, animations,
/// morph targets, cameras, extensions but for KHR_texture_transform). damaged when a number leads
/// out of what it counts, a length is more than there is, nodes do not form trees, or nesting is
/// deep; unsupported when it is no glTF 2 or requires an extension.
Result<Bytes> sanitizedGltf(ByteView bytes);

}  // namespace rocinante
