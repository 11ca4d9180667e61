#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/kinematics/kinematics.h"

namespace rocinante {

/// A joint of a device, with where its values stand in a positional `joints DEVICE ...`.
struct InfoJoint {
  const Model* model = nullptr;
  std::size_t joint = 0;                   ///< into model->joints
  std::optional<std::size_t> first_value;  ///< from 0; empty: it takes none
};

/// A file on disk; without a size when it could not be asked.
struct InfoFile {
  std::string name;
  std::optional<std::uint64_t> bytes;
};

struct InfoDevice {
  const CellDevice* device = nullptr;
  const Model* model = nullptr;  ///< null: it could not be read
  std::vector<InfoJoint> joints;
  std::size_t movable = 0;      ///< joints that a sender drives
  std::size_t values = 0;       ///< that a positional `joints` takes
  std::uint64_t triangles = 0;  ///< as drawn
  Bounds bounds;  ///< in the world at zero joints, hidden links too; empty: no geometry
};

/// What `rocinante model info` tells of a cell or a model (docs/programs/model.md). Borrows from
/// the cell.
struct ModelInfo {
  const Cell* cell = nullptr;
  std::string name;  ///< of the only device's model, else of the file
  std::vector<InfoDevice> devices;
  std::vector<const Model*> models;  ///< of those devices, each once, as they come
  std::size_t movable = 0;
  std::uint64_t triangles = 0;
  std::uint64_t meshes = 0;          ///< different ones
  std::uint64_t geometry_bytes = 0;  ///< of them in memory, each once
  std::vector<InfoFile> textures;    ///< different ones, by name
  /// Different names of pictures that are not used, because they are missing or may not be opened.
  std::vector<std::string> textures_missing;
  std::size_t meshes_missing = 0;  ///< times that a visual or collision names one in vain
  Bounds bounds;

  /// Whether names need their device before them to be told apart.
  bool severalDevices() const { return devices.size() != 1; }
};

/// Of one device, or of all when `device` is empty. The cell must have been loaded with geometry.
Result<ModelInfo> modelInfo(const Cell& cell, const std::string& device);

/// "-166.003° to 166.003°", "unlimited"; empty for joints that have no bounds at all.
std::string limitsText(const Joint& joint);

}  // namespace rocinante
