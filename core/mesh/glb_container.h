#pragma once

#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// The chunks of a .glb (glTF 2.0, "Binary glTF Layout"); for a .gltf the whole file is the text.
/// Borrowed.
struct GltfParts {
  std::string_view text;
  ByteView binary;
};

bool isGlb(ByteView bytes);

/// damaged when a chunk ends behind the file, unsupported for another version than 2. Errors have
/// no place: the caller knows it.
Result<GltfParts> gltfParts(ByteView bytes);

/// A .glb of these parts.
Bytes glbOf(const GltfParts& parts);

}  // namespace rocinante
