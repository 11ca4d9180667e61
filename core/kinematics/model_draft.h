#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/document/fault_list.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// Warns, at `place`, of a model that has collision geometry and no visual: nothing of it is drawn
/// (docs/rules/model.md, "model.no-visual").
void judgeVisibility(const Model& model, Place place, FaultList& faults);

/// More than any machine has; a file with more is refused (docs/cell-format.md, "Limits").
inline constexpr std::size_t kMaxLinks = 65536;

struct MimicDraft {
  std::string joint;
  double multiplier = 1, offset = 0;
  Place place;
};

/// A joint as a file writes it: by names, which may not exist.
struct JointDraft {
  Joint joint;
  std::string parent, child;  ///< names of links
  Place place, parent_place, child_place;
  std::optional<MimicDraft> mimic;
};

struct LinkDraft {
  Link link;
  Place place;
};

/// A model as it was read, before its names are joined.
struct ModelDraft {
  std::string name;
  std::string file;
  std::string rules;           ///< first word of its faults' rules: "urdf" or "cell"
  Place place;                 ///< of the model as a whole
  bool several_roots = false;  ///< the format allows links that no joint connects
  std::vector<LinkDraft> links;
  std::vector<JointDraft> joints;
};

/// Joins names to a tree. Invalid joints (unknown or equal links, a second parent, a loop) are left
/// out and invalid mimics are removed, each with a fault. Empty when there is no link.
std::optional<Model> finishModel(ModelDraft&& draft, FaultList& faults);

}  // namespace rocinante
