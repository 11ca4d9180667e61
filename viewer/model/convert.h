#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "viewer/model/pose_request.h"

namespace rocinante {

struct ConvertJob {
  /// Its ending says the form: .obj (with .mtl and textures), .stl, .cell.toml (with those of
  /// .obj).
  std::filesystem::path output;
  bool overwrite = false;
  PoseRequest pose;
};

struct ConvertReport {
  std::vector<std::filesystem::path> files;  ///< as they were written, `output` last
  std::uint64_t triangles = 0;
  std::vector<std::string> warnings;  ///< what the form cannot hold
};

/// Writes what a cell shows, or the model of one device with its kinematics, in another form
/// (docs/programs/model.md, "convert"). All files appear or none; refused when one exists and
/// `overwrite` is false. The same input gives the same bytes.
Result<ConvertReport> convertModel(const Cell& cell, const ConvertJob& job);

}  // namespace rocinante
