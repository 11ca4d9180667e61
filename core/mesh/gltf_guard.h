#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

// Keeps files from assimp that would crash the program or fill the memory (for COLLADA:
// core/mesh/collada_guard.h).

/// The same glTF file, text or binary, without parts that are not drawn (skins, animations, morph
/// targets, cameras, extensions except KHR_texture_transform). damaged when an index is out of
/// range, a length exceeds its buffer, nodes do not form trees, or nesting is too deep; unsupported
/// when it is not glTF 2 or requires an extension.
Result<Bytes> sanitizedGltf(ByteView bytes);

}  // namespace rocinante
