#pragma once

#include <cstdint>
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

/// The beginning of a .glb, up to its binary chunk of `binary_bytes`, a multiple of 4, which
/// follows; 0: there is none. The whole file is smaller than 4 GiB.
Bytes glbHead(std::string_view text, std::uint64_t binary_bytes);

}  // namespace rocinante
