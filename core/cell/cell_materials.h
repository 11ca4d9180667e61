#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/document/toml_table.h"
#include "core/mesh/mesh_store.h"

namespace rocinante {

/// One `[[material]]`: its changes, and patterns for the things it changes, empty for all.
struct MaterialChange {
  std::string device, link, group, material;
  std::optional<glm::vec4> color;
  std::optional<glm::vec3> specular, emission;
  std::optional<float> shininess;
  std::optional<std::filesystem::path> texture;  ///< an empty one removes the texture
  std::optional<glm::vec2> texture_scale, texture_offset;
  std::optional<float> texture_rotation;  ///< radians
  std::optional<TextureWrap> texture_wrap;
  std::optional<AlphaMode> alpha;
  std::optional<float> alpha_cutoff;
};

/// The `[[material]]` tables of a cell (docs/cell-format.md, section "Materials"). Models whose
/// looks they change are replaced by copies that share geometry; kinematics stay as they are.
class CellMaterials {
 public:
  /// Reads those of one file of the cell, in `folder`: later changes override earlier ones.
  void read(TomlTable& root, const std::filesystem::path& folder, MeshStore& meshes);
  /// When models and devices are known: changes Cell::models and CellDevice::dressed.
  void apply(Cell& cell);

 private:
  struct Change {
    MaterialChange what;
    TomlTable table;
    bool used = false;
  };
  using Chosen = std::vector<std::size_t>;  // into changes_, in order

  std::shared_ptr<const Model> dressed(const Model& model, const Chosen& chosen);
  bool matches(const Change& change, const Link& link, const MeshPart& part,
               const Material& material) const;

  std::vector<Change> changes_;
};

}  // namespace rocinante
