#pragma once

#include <optional>
#include <string_view>

#include "core/base/bytes.h"
#include "viewer/detail/mesh_detail.h"

namespace rocinante {

/// The bytes of one file of the cache: a header with the version of this layout, of meshoptimizer
/// and the key, the parts, the indices, and the XXH3 of all of it. Little-endian.
Bytes encodeDetail(const MeshDetail& detail, std::string_view key);

/// Empty unless encodeDetail() wrote the bytes for this mesh: for another version or key, damage,
/// truncation, or an index past the mesh's vertices. Lengths are checked before allocation.
std::optional<MeshDetail> decodeDetail(ByteView bytes, std::string_view key,
                                       const DetailInput& input);

}  // namespace rocinante
