#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "core/document/toml_table.h"
#include "viewer/model/model_writers.h"

namespace rocinante {
namespace {

std::string vectorText(const Vec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

std::string poseText(const Pose& pose) {
  const Quat& q = pose.orientation;
  if (q == Quat(1, 0, 0, 0)) return fmt::format("{{ xyz = {} }}", vectorText(pose.position));
  return fmt::format("{{ xyz = {}, quaternion = [{}, {}, {}, {}] }}", vectorText(pose.position),
                     q.x, q.y, q.z, q.w);
}

std::string jointText(const Model& model, const Joint& joint) {
  std::string text =
      fmt::format("{{ name = {}, type = \"{}\"", tomlText(joint.name), nameOf(joint.type));
  if (joint.type != JointType::fixed && joint.type != JointType::floating) {
    text += ", axis = " + vectorText(joint.axis);
  }
  text += ", origin = " + poseText(joint.origin);
  if (joint.limits) {
    const JointLimits& limits = *joint.limits;
    if (std::isfinite(limits.lower) && std::isfinite(limits.upper)) {
      text += fmt::format(", limits = [{}, {}]", limits.lower, limits.upper);
    }
    if (limits.velocity) text += fmt::format(", velocity = {}", *limits.velocity);
    if (limits.effort) text += fmt::format(", effort = {}", *limits.effort);
  }
  if (joint.mimic) {
    text += fmt::format(", mimic = {{ joint = {}, multiplier = {}, offset = {} }}",
                        tomlText(model.joints[joint.mimic->joint].name), joint.mimic->multiplier,
                        joint.mimic->offset);
  }
  return text + " }";
}

// The root, then the child of each joint, so that the joints keep the order of their values.
std::vector<std::size_t> linksInOrder(const Model& model) {
  std::vector<std::size_t> links;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (!model.links[i].parent_joint) links.push_back(i);
  }
  for (const Joint& joint : model.joints) links.push_back(joint.child);
  return links;
}

std::string colorText(const glm::vec4& color) {
  std::string text = "#";
  for (int i = 0; i < 4; ++i) text += fmt::format("{:02x}", std::lround(color[i] * 255.0F));
  return text;
}

std::string nameWithoutSlashes(std::string name) {
  for (char& c : name) c = c == '/' ? '_' : c;
  return name.empty() ? "model" : name.substr(0, 255);
}

}  // namespace

std::string cellText(const CellDevice& device, const Model& model, const std::string& obj_file,
                     const std::vector<std::string>& groups) {
  const std::string name = nameWithoutSlashes(model.name);
  std::string text = "format = 1\n\n[[device]]\n";
  text += fmt::format("name = {}\nmodel = {}\n", tomlText(device.name), tomlText(name));
  if (!(device.pose == Pose{})) text += fmt::format("pose = {}\n", poseText(device.pose));
  if (!device.layer.empty()) text += fmt::format("layer = {}\n", tomlText(device.layer));
  if (!device.tags.empty()) {
    std::vector<std::string> tags;
    for (const std::string& tag : device.tags) tags.push_back(tomlText(tag));
    text += fmt::format("tags = [{}]\n", fmt::join(tags, ", "));
  }
  if (device.color) text += fmt::format("color = \"{}\"\n", colorText(*device.color));
  text += fmt::format("\n[[model]]\nname = {}\nobj = {}\nunit = \"m\"\nup = \"z\"\n",
                      tomlText(name), tomlText(obj_file));
  for (const std::size_t i : linksInOrder(model)) {
    const Link& link = model.links[i];
    text += fmt::format("\n[[model.link]]\nname = {}\n", tomlText(link.name));
    // Written even when empty: a root without `groups` would take the remaining groups.
    const std::string group = groups[i].empty() ? "" : tomlText(groups[i]);
    text += fmt::format("groups = [{}]\n", group);
    if (!link.parent_joint) continue;
    const Joint& joint = model.joints[*link.parent_joint];
    text += fmt::format("parent = {}\njoint = {}\n", tomlText(model.links[joint.parent].name),
                        jointText(model, joint));
  }
  return text;
}

}  // namespace rocinante
