#pragma once

#include <filesystem>
#include <optional>

#include "core/base/bytes.h"
#include "core/kinematics/model.h"
#include "core/mesh/mesh_store.h"

namespace rocinante {

/// Most bytes and elements of a URDF file; more is refused.
inline constexpr std::size_t kMaxUrdfBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxUrdfElements = std::size_t{1} << 20;

/// Reads URDF (docs/cell-format.md, section "URDF") from bytes; `path` names them, and names in
/// them are looked for beside it. All faults are added, with line and column, and everything valid
/// is returned; empty when nothing is: no XML, no <robot>, no link, or a xacro template.
std::optional<Model> readUrdf(ByteView bytes, const std::filesystem::path& path, MeshStore& meshes,
                              Findings& faults);

}  // namespace rocinante
