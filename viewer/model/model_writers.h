#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "core/report/account.h"

namespace rocinante {

/// A run of triangles of one material with its world transform. Borrows from scene and model.
struct PosedPart {
  const PosedDevice* device = nullptr;
  std::size_t link = 0;  ///< of the device's model
  const Mesh* mesh = nullptr;
  const MeshPart* part = nullptr;
  Material material;      ///< with overrides of cell or session
  bool tinted = false;    ///< by the mesh's vertex colours
  Mat4 to_world{1.0};     ///< with the visual's scale
  bool mirrored = false;  ///< to_world flips the winding
};

/// Calls `each` for every part of one device's visuals, links in model order. `shown_only` leaves
/// out hidden ones.
void forEachPart(const PosedDevice& device, bool shown_only,
                 const std::function<void(const PosedPart&)>& each);

/// A mesh point in world space, and a normal there (unit length; zero stays zero).
Vec3 worldPoint(const PosedPart& part, const glm::vec3& point);
Vec3 worldNormal(const PosedPart& part, const glm::vec3& normal);

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

/// Posed geometry as binary STL: metres, z up; without groups, colours and smooth normals, which
/// the format lacks.
class StlWriter {
 public:
  StlWriter();
  void add(const PosedPart& part);
  /// Returns the file; nothing can be added afterwards.
  std::string finish();
  std::uint64_t triangles() const { return triangles_; }

 private:
  std::string bytes_;
  std::uint64_t triangles_ = 0;
};

/// A cell of one device (docs/cell-format.md): its kinematics as [[model.link]] tables over the
/// groups of an OBJ. `groups` is by link of the model: empty for links without geometry. Numbers
/// are the shortest that read back as the same double.
std::string cellText(const CellDevice& device, const Model& model, const std::string& obj_file,
                     const std::vector<std::string>& groups);

}  // namespace rocinante
