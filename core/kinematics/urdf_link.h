#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/kinematics/mesh_scale.h"
#include "core/kinematics/model_draft.h"
#include "core/kinematics/urdf_element.h"
#include "core/mesh/mesh_store.h"

namespace rocinante {

/// Reads `<link>`s with their geometry, and the materials that they share by name.
class UrdfLinkReader {
 public:
  UrdfLinkReader(MeshStore& meshes, std::filesystem::path folder)
      : meshes_(meshes), folder_(std::move(folder)) {}

  /// A `<material>` of the robot or of a visual: its name is valid everywhere in the file.
  void addMaterial(const UrdfElement& element);
  std::optional<LinkDraft> readLink(const UrdfElement& element);
  /// Every mesh file of a visual or a collision, and its size there.
  const std::vector<MeshUse>& meshUses() const { return mesh_uses_; }
  /// After everything is read: gives visuals the materials that they name, wherever those are
  /// defined.
  void resolveMaterials(std::vector<LinkDraft>& links, FaultList& faults) const;

 private:
  struct Wanted {
    std::size_t link;
    std::optional<std::size_t>
        visual;  // empty: its mesh has its own, but the name must lead somewhere
    std::string material;
    Place place;
  };
  std::optional<Material> readMaterial(const UrdfElement& element);
  void define(const UrdfElement& element, const Material& material);
  void readVisual(const UrdfElement& element, Link& link);
  std::optional<Visual> readGeometry(const UrdfElement& owner, const std::string& link);
  std::shared_ptr<const Mesh> readShape(const UrdfElement& shape, Vec3& scale, bool& sound);
  std::optional<double> size(const UrdfElement& shape, const char* attribute) const;

  MeshStore& meshes_;
  std::filesystem::path folder_;
  std::map<std::string, Material> materials_;
  std::map<std::string, Place> material_places_;
  std::vector<Wanted> wanted_;
  std::size_t link_count_ = 0;
  std::vector<MeshUse> mesh_uses_;
};

}  // namespace rocinante
