#pragma once

#include <filesystem>
#include <optional>

#include "core/base/bytes.h"
#include "core/kinematics/model.h"
#include "core/mesh/mesh_store.h"

namespace rocinante {

/// Most bytes of an SDF file; more is refused.
inline constexpr std::size_t kMaxSdfBytes = std::size_t{64} << 20;

/// Reads the first model of an SDF file (docs/meshes.md, section "SDF") by libsdformat, which sits
/// in a module (librocinante_sdformat.so): linking it would cost every program 26 ms at start.
/// Everything valid is returned, as with readUrdf; empty with an error where there is no module.
/// `<include>` is not followed. For one thread at a time.
std::optional<Model> readSdf(ByteView bytes, const std::filesystem::path& path, MeshStore& meshes,
                             Findings& faults);

}  // namespace rocinante
