#pragma once

#include <tinyxml2.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/fault_list.h"
#include "core/document/xml_places.h"
#include "core/kinematics/mesh_scale.h"
#include "core/kinematics/model_draft.h"
#include "core/math/vector.h"
#include "core/mesh/mesh_store.h"

namespace rocinante {

/// The context for reading one URDF file; borrowed by the readers of its parts.
struct UrdfContext {
  const XmlPlaces& places;
  FaultList& faults;
};

/// One element with typed attributes. A malformed value is a fault with its place, and reads as if
/// the attribute were absent.
class UrdfElement {
 public:
  UrdfElement(const tinyxml2::XMLElement& element, const UrdfContext& context)
      : element_(&element), context_(&context) {}

  std::string_view tag() const { return element_->Name(); }
  Place place() const { return context_->places.of(*element_); }
  Place place(std::string_view attribute) const {
    return context_->places.of(*element_, attribute);
  }
  FaultList& faults() const { return context_->faults; }

  /// The child element of that name; a fault when there are several (the first is used).
  std::optional<UrdfElement> child(const char* name) const;
  /// Calls `use` for each child element of that name.
  template <class Use>
  void each(const char* name, Use use) const {
    for (const auto* e = element_->FirstChildElement(name); e; e = e->NextSiblingElement(name)) {
      use(UrdfElement(*e, *context_));
    }
  }
  template <class Use>
  void eachChild(Use use) const {
    for (const auto* e = element_->FirstChildElement(); e; e = e->NextSiblingElement()) {
      use(UrdfElement(*e, *context_));
    }
  }
  bool has(const char* attribute) const { return element_->Attribute(attribute) != nullptr; }
  /// Empty when absent.
  std::string text(const char* attribute) const;
  /// The text; a fault and empty when the attribute is absent or empty.
  std::optional<std::string> requiredText(const char* attribute) const;
  std::optional<double> number(const char* attribute) const;
  std::optional<double> requiredNumber(const char* attribute) const;
  std::optional<Vec3> vector(const char* attribute) const;
  std::optional<Vec4> vector4(const char* attribute) const;
  /// `<origin xyz rpy>`, or with `quat_xyzw` in place of `rpy`, below this element; identity when
  /// absent.
  Pose origin() const;

 private:
  bool numbers(const char* attribute, double* values, std::size_t count) const;
  void missing(const char* attribute) const;

  const tinyxml2::XMLElement* element_;
  const UrdfContext* context_;
};

/// Reads one `<joint>`; empty with a fault when it has no name, parent or child.
std::optional<JointDraft> readUrdfJoint(const UrdfElement& element);

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
