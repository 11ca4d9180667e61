#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/document/toml_table.h"
#include "core/kinematics/model.h"
#include "core/kinematics/model_draft.h"
#include "core/mesh/mesh_store.h"

namespace rocinante {

/// Reads a `[[model]]` with `obj` or `stl`: kinematics written over the groups of one file
/// (docs/cell-format.md, section "Models"). `folder` is the cell's. Faults go to the table's list;
/// null when nothing of it can be used.
std::shared_ptr<const Model> readInlineModel(TomlTable& table, const std::string& name,
                                             const std::filesystem::path& folder,
                                             MeshStore& meshes);

/// The meshes that readInlineModel will ask for, of all tables of a cell's `document`: to be read
/// ahead. Invalid ones are skipped.
std::vector<MeshWanted> meshesOfInlineModels(const TomlNode& document,
                                             const std::filesystem::path& folder);

/// A model of one link that carries all of `mesh`, which may be null.
Model rigidModel(std::string name, std::string file, std::shared_ptr<const Mesh> mesh);

/// Reads the `joint` of a link of an inline `[[model]]` (docs/cell-format.md, "Joints"). Faults go
/// to the table's list; empty when the joint has no usable name.
std::optional<JointDraft> readInlineJoint(TomlTable& table, const std::string& parent,
                                          const std::string& child);

}  // namespace rocinante
