#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/kinematics/kinematics.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// A joint of a device and the position of its values in `joints DEVICE ...`.
struct InfoJoint {
  const Model* model = nullptr;
  std::size_t joint = 0;                   ///< into model->joints
  std::optional<std::size_t> first_value;  ///< from 0; empty: no value
};

/// A file on disk; without a size when unreadable.
struct InfoFile {
  std::string name;
  std::optional<std::uint64_t> bytes;
};

struct InfoDevice {
  const CellDevice* device = nullptr;
  const Model* model = nullptr;  ///< null: it could not be read
  std::vector<InfoJoint> joints;
  std::size_t movable = 0;      ///< joints driven by a sender
  std::size_t values = 0;       ///< of a positional `joints`
  std::uint64_t triangles = 0;  ///< as drawn
  Bounds bounds;  ///< in the world at zero joints, hidden links too; empty: no geometry
};

/// The content of `rocinante model info` for a cell or a model (docs/programs/model.md). Borrows
/// from the cell.
struct ModelInfo {
  const Cell* cell = nullptr;
  std::string name;  ///< of the single device's model, else of the file
  std::vector<InfoDevice> devices;
  std::vector<const Model*> models;  ///< of those devices, each once, in their order
  std::size_t movable = 0;
  std::uint64_t triangles = 0;
  std::uint64_t meshes = 0;          ///< different ones
  std::uint64_t geometry_bytes = 0;  ///< their size in memory, each once
  std::vector<InfoFile> textures;    ///< different ones, by name
  /// Different names of pictures that are not used because they are missing or inaccessible.
  std::vector<std::string> textures_missing;
  std::size_t meshes_missing = 0;  ///< visuals and collisions whose mesh is missing
  Bounds bounds;

  /// Whether names need a device prefix.
  bool severalDevices() const { return devices.size() != 1; }
};

/// Information on one device, or all when `device` is empty. The cell must have been loaded with
/// geometry.
Result<ModelInfo> modelInfo(const Cell& cell, const std::string& device);

/// "-166.003° to 166.003°", "unlimited"; empty for joints without bounds.
std::string limitsText(const Joint& joint);

/// The information as JSON.
std::string modelInfoJson(const ModelInfo& info);

/// The information as text.
std::string modelInfoText(const ModelInfo& info);

/// The links of a model as a tree, one per line, each with its joint, the joint's type and limits.
/// Drawn with box-drawing characters or only ASCII. Beyond 64 levels lines are not indented further
/// but show their depth.
std::string treeText(const Model& model, bool ascii);

}  // namespace rocinante
