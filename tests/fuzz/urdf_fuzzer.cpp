// Any bytes as URDF. What comes back must be a tree that can be moved.

#include <cmath>
#include <cstdlib>

#include "core/kinematics/kinematics.h"
#include "core/kinematics/urdf_reader.h"

using namespace rocinante;

namespace {

void require(bool sound) {
  if (!sound) std::abort();
}

void requireTree(const Model& model) {
  require(model.root < model.links.size() && !model.links[model.root].parent_joint);
  require(model.update_order.size() == model.joints.size());
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    require(joint.parent < model.links.size() && joint.child < model.links.size());
    require(model.links[joint.child].parent_joint == i);
    require(!joint.mimic ||
            (joint.mimic->joint < model.joints.size() && valueCount(joint.type) == 1));
    require(std::fabs(glm::dot(joint.axis, joint.axis) - 1) < 1e-12);
  }
  JointVector joints = zeroJoints(model);
  for (double& value : joints.values) value = 0.5;
  applyMimics(model, joints);
  require(linkPoses(model, joints).size() == model.links.size());
  static_cast<void>(kinematicsHash(model));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Findings faults;
  const FileSearch search;  // without a root nothing is found, so nothing is opened
  MeshStore meshes(search, true);
  const auto model = readUrdf(std::as_bytes(std::span(data, size)), "fuzz.urdf", meshes, faults);
  if (model) requireTree(*model);
  for (const Finding& fault : faults) require(!fault.print().empty());
  require(model || !faults.empty());
  return 0;
}
