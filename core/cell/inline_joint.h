#pragma once

#include <optional>
#include <string>

#include "core/document/toml_table.h"
#include "core/kinematics/model_draft.h"

namespace rocinante {

/// Reads the `joint` of a link of an inline `[[model]]` (docs/cell-format.md, "Joints"). Faults go
/// to the table's list; empty when the joint has no usable name.
std::optional<JointDraft> readInlineJoint(TomlTable& table, const std::string& parent,
                                          const std::string& child);

}  // namespace rocinante
