#include <fmt/format.h>

#include <cmath>

#include "core/report/account.h"
#include "core/report/json_text.h"
#include "viewer/model/model_info.h"

namespace rocinante {
namespace {

Json finiteOrNull(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json vectorJson(const Vec3& vector) { return {vector.x, vector.y, vector.z}; }

Json boundsJson(const Bounds& bounds) {
  if (bounds.empty()) return nullptr;
  return {{"min", vectorJson(bounds.min)}, {"max", vectorJson(bounds.max)}};
}

// A name, prefixed with its device if there are several.
std::string named(const ModelInfo& info, const InfoDevice& device, const std::string& name) {
  return info.severalDevices() ? device.device->name + "/" + name : name;
}

Json jointJson(const ModelInfo& info, const InfoDevice& device, const InfoJoint& entry) {
  const Model& model = *entry.model;
  const Joint& joint = model.joints[entry.joint];
  const JointLimits* limits = joint.limits ? &*joint.limits : nullptr;
  const auto limit = [&](auto member) {
    return limits == nullptr ? Json(nullptr) : finiteOrNull(limits->*member);
  };
  Json mimic = nullptr;
  if (joint.mimic) {
    mimic = {{"joint", named(info, device, model.joints[joint.mimic->joint].name)},
             {"multiplier", joint.mimic->multiplier},
             {"offset", joint.mimic->offset}};
  }
  Json out;
  out["name"] = named(info, device, joint.name);
  out["type"] = nameOf(joint.type);
  out["parent"] = named(info, device, model.links[joint.parent].name);
  out["child"] = named(info, device, model.links[joint.child].name);
  out["lower"] = limit(&JointLimits::lower);
  out["upper"] = limit(&JointLimits::upper);
  out["mimic"] = std::move(mimic);
  out["velocity"] = limit(&JointLimits::velocity);
  out["effort"] = limit(&JointLimits::effort);
  out["axis"] = vectorJson(joint.axis);
  out["position"] = orNull(entry.first_value);
  return out;
}

Json poseJson(const Pose& pose) {
  const Quat& turn = pose.orientation;
  return {{"xyz", vectorJson(pose.position)}, {"quaternion", {turn.x, turn.y, turn.z, turn.w}}};
}

std::string kinematicsText(const Model& model) {
  return fmt::format("{:016x}", kinematicsHash(model));
}

Json deviceJson(const InfoDevice& entry) {
  const CellDevice& device = *entry.device;
  Json out;
  out["name"] = device.name;
  out["model"] = device.model;
  out["kinematics"] = entry.model == nullptr ? Json(nullptr) : Json(kinematicsText(*entry.model));
  out["movable"] = entry.movable;
  out["values"] = entry.values;
  out["triangles"] = entry.triangles;
  out["bounds_m"] = boundsJson(entry.bounds);
  out["pose"] = poseJson(device.pose);
  std::string on = device.on_device;
  if (!device.on_link.empty()) on += "/" + device.on_link;
  out["on"] = orNull(on);
  out["layer"] = orNull(device.layer);
  out["tags"] = device.tags;
  out["optional"] = device.optional;
  return out;
}

Json faultsJson(const ModelInfo& info) {
  Json out = Json::array();
  for (const Finding& fault : info.cell->faults) {
    out.push_back({{"file", info.cell->shown(fault.file)},
                   {"line", fault.line},
                   {"column", fault.column},
                   {"severity", nameOf(fault.severity)},
                   {"rule", fault.rule},
                   {"text", info.cell->shown(sentenceOf(fault))},
                   {"hint", fault.hint}});
  }
  return out;
}

}  // namespace

std::string modelInfoJson(const ModelInfo& info) {
  Json links = Json::array(), joints = Json::array(), devices = Json::array();
  std::size_t values = 0;
  for (const InfoDevice& device : info.devices) {
    values += device.values;
    devices.push_back(deviceJson(device));
    if (device.model == nullptr) continue;
    for (const Link& link : device.model->links) links.push_back(named(info, device, link.name));
    for (const InfoJoint& joint : device.joints) joints.push_back(jointJson(info, device, joint));
  }
  Json textures = Json::array(), cameras = Json::array(), layers = Json::array();
  for (const InfoFile& texture : info.textures) {
    textures.push_back({{"file", texture.name}, {"bytes", orNull(texture.bytes)}});
  }
  for (const CellCamera& camera : info.cell->cameras) cameras.push_back(camera.name);
  for (const CellLayer& layer : info.cell->layers) layers.push_back(layer.name);

  Json out;
  out["format"] = 1;
  out["file"] = info.cell->shown(info.cell->file);
  out["name"] = info.name;
  out["links"] = std::move(links);
  out["joints"] = std::move(joints);
  out["movable"] = info.movable;
  out["values"] = values;
  out["kinematics"] = info.models.size() == 1 ? Json(kinematicsText(*info.models[0])) : nullptr;
  out["triangles"] = info.triangles;
  out["meshes"] = info.meshes;
  out["meshes_missing"] = info.meshes_missing;
  out["textures"] = info.textures.size();
  out["textures_missing"] = info.textures_missing;
  out["texture_files"] = std::move(textures);
  out["geometry_bytes"] = info.geometry_bytes;
  out["bounds_m"] = boundsJson(info.bounds);
  out["devices"] = std::move(devices);
  out["cameras"] = std::move(cameras);
  out["layers"] = std::move(layers);
  out["faults"] = faultsJson(info);
  out["left_out"] = leftOutJson(accountOf(info.cell->faults));
  return jsonText(out);
}

}  // namespace rocinante
