#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/report/account.h"
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
/// back as the same float; colours by vertex behind the positions, as MeshLab and others write
/// them. The same input gives the same bytes.
class ObjWriter {
 public:
  /// `material_file` is the MTL's name; textures are in `texture_folder` beside it.
  ObjWriter(std::string material_file, std::string texture_folder);

  /// Starts the group of the following parts.
  void beginGroup(std::string_view name);
  void add(const PosedPart& part);

  const std::string& objText() const { return obj_; }
  const std::string& mtlText() const { return mtl_; }
  struct Picture {
    std::filesystem::path file;          ///< a name for `bytes` when there are any
    std::shared_ptr<const Bytes> bytes;  ///< null: those of the file
    std::string name;                    ///< in the MTL
  };
  /// Pictures used by the MTL.
  const std::vector<Picture>& textures() const { return textures_; }
  /// What of the materials neither format can say.
  const Account& leftOut() const { return left_out_; }
  std::uint64_t triangles() const { return triangles_; }

 private:
  std::string materialName(const Material& material);
  void nameLosses(const Material& material);
  std::string textureName(const Material& material);

  std::string texture_folder_;
  std::string obj_, mtl_;
  std::map<std::string, std::string> materials_;  // by appearance
  std::map<std::filesystem::path, std::string> texture_names_;
  std::vector<Picture> textures_;
  std::set<std::string> judged_;  // materials, for left_out_
  Account left_out_;
  PlainNames material_names_, picture_names_;
  std::uint64_t points_ = 0, normals_ = 0, corners_ = 0, triangles_ = 0;
};

}  // namespace rocinante
