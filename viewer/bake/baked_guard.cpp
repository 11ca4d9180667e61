#include "viewer/bake/baked_guard.h"

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

bool isFiniteVertex(const Vertex& vertex) {
  const auto& [p, n, t] = vertex;
  // A sum is not finite if a term is not; terms near the limit of floats are none of a machine.
  return std::isfinite(p.x + p.y + p.z + n.x + n.y + n.z + t.x + t.y);
}

bool partsAreWithin(const std::vector<Visual>& visuals) {
  return std::all_of(visuals.begin(), visuals.end(), [](const Visual& visual) {
    return !visual.mesh ||
           std::all_of(visual.mesh_parts.begin(), visual.mesh_parts.end(),
                       [&](std::size_t part) { return part < visual.mesh->parts.size(); });
  });
}

bool namesAreWithin(const std::map<std::string, std::size_t, std::less<>>& names,
                    std::size_t count) {
  return std::all_of(names.begin(), names.end(),
                     [&](const auto& each) { return each.second < count; });
}

/// Follows each chain of mimics once.
bool mimicsEnd(const std::vector<Joint>& joints) {
  std::vector<std::size_t> seen_by(joints.size(), joints.size());
  for (std::size_t first = 0; first < joints.size(); ++first) {
    std::size_t at = first;
    while (joints[at].mimic && seen_by[at] == joints.size()) {
      seen_by[at] = first;
      at = joints[at].mimic->joint;
    }
    if (joints[at].mimic && seen_by[at] == first) return false;
  }
  return true;
}

}  // namespace

const char* faultOfMesh(const Mesh& mesh) {
  const std::size_t vertices = mesh.vertices.size();
  if (std::any_of(mesh.indices.begin(), mesh.indices.end(),
                  [&](std::uint32_t index) { return index >= vertices; })) {
    return "an index past the vertices";
  }
  if (mesh.indices.size() % 3 != 0) return "a triangle without three corners";
  if (!mesh.colors.empty() && mesh.colors.size() != vertices) return "colours of other vertices";
  for (const MeshPart& part : mesh.parts) {
    if (part.material >= mesh.materials.size()) return "a part without a material";
    if (part.first_index % 3 != 0 || part.index_count % 3 != 0 ||
        std::uint64_t{part.first_index} + part.index_count > mesh.indices.size()) {
      return "a part past the indices";
    }
  }
  if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), isFiniteVertex)) {
    return "a vertex that is not finite";
  }
  return nullptr;
}

const char* faultOfModel(const Model& model) {
  const std::size_t links = model.links.size();
  const std::size_t joints = model.joints.size();
  if (links == 0 ? model.root != 0 : model.root >= links)
    return "the root is not a link of the model";
  if (!namesAreWithin(model.link_by_name, links) || !namesAreWithin(model.joint_by_name, joints)) {
    return "a name of no link or joint";
  }
  for (std::size_t i = 0; i < joints; ++i) {
    const Joint& joint = model.joints[i];
    if (joint.parent >= links || joint.child >= links) return "a joint without links";
    if (model.links[joint.child].parent_joint != i) return "a link with two joints above it";
    if (joint.mimic && (joint.mimic->joint >= joints || valueCount(joint.type) != 1 ||
                        valueCount(model.joints[joint.mimic->joint].type) != 1)) {
      return "a mimic of no joint";
    }
  }
  if (!mimicsEnd(model.joints)) return "joints that mimic each other";
  for (std::size_t i = 0; i < links; ++i) {
    const Link& link = model.links[i];
    if (link.parent_joint &&
        (*link.parent_joint >= joints || model.joints[*link.parent_joint].child != i)) {
      return "a link below no joint";
    }
    if (!partsAreWithin(link.visuals) || !partsAreWithin(link.collisions))
      return "a part of no mesh";
  }
  if (model.update_order.size() != joints) return "joints that are not updated";
  std::vector<bool> updated(joints, false);
  for (const std::size_t joint : model.update_order) {
    if (joint >= joints || updated[joint]) return "an order of no joints";
    const auto above = model.links[model.joints[joint].parent].parent_joint;
    if (above && !updated[*above]) return "a joint that is updated before the one above it";
    updated[joint] = true;
  }
  return nullptr;
}

const char* faultOfCell(const Cell& cell) {
  return namesAreWithin(cell.device_by_name, cell.devices.size()) ? nullptr : "a name of no device";
}

}  // namespace rocinante
