#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "viewer/model/posed_parts.h"

namespace rocinante {

/// Makes unique names of letters, digits, `_`, `.` and `-`, which need no quotes in any file and
/// match themselves as patterns.
class PlainNames {
 public:
  /// `name` with other bytes as `_`, and a number appended to repeated names.
  std::string of(std::string_view name);

 private:
  std::set<std::string, std::less<>> taken_;
};

/// Posed geometry as Wavefront OBJ with its MTL: metres, z up, every number the shortest that reads
/// back as the same float. The same input gives the same bytes.
class ObjWriter {
 public:
  /// `material_file` is the MTL's name; textures are in `texture_folder` beside it.
  ObjWriter(std::string material_file, std::string texture_folder);

  /// Starts the group of the following parts.
  void beginGroup(std::string_view name);
  void add(const PosedPart& part);

  const std::string& objText() const { return obj_; }
  const std::string& mtlText() const { return mtl_; }
  /// Pictures used by the MTL: source path and name in the MTL.
  const std::vector<std::pair<std::filesystem::path, std::string>>& textures() const {
    return textures_;
  }
  std::uint64_t triangles() const { return triangles_; }

 private:
  std::string materialName(const Material& material);
  std::string textureName(const std::filesystem::path& file);

  std::string texture_folder_;
  std::string obj_, mtl_;
  std::map<std::string, std::string> materials_;  // by appearance
  std::map<std::filesystem::path, std::string> texture_names_;
  std::vector<std::pair<std::filesystem::path, std::string>> textures_;
  PlainNames material_names_, picture_names_;
  std::uint64_t points_ = 0, normals_ = 0, corners_ = 0, triangles_ = 0;
};

}  // namespace rocinante
