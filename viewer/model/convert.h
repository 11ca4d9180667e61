#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/report/account.h"
#include "viewer/model/pose_request.h"

namespace rocinante {

struct ConvertJob {
  /// Its extension selects the format: .obj (with .mtl and textures), .stl, .cell.toml (with the
  /// files of .obj).
  std::filesystem::path output;
  bool overwrite = false;
  PoseRequest pose;
};

struct ConvertReport {
  std::vector<std::filesystem::path> files;  ///< in the order written, `output` last
  std::uint64_t triangles = 0;
  Account left_out;  ///< losses of the format
};

/// Writes the geometry of a cell, or the model of one device with its kinematics, in another format
/// (docs/programs/model.md, "convert"). All files appear or none; refused when one exists and
/// `overwrite` is false. The same input gives the same bytes.
Result<ConvertReport> convertModel(const Cell& cell, const ConvertJob& job);

}  // namespace rocinante
