#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/cli/text_table.h"
#include "core/report/account.h"
#include "viewer/model/model_info.h"

namespace rocinante {
namespace {

using cli::counted;
using cli::grouped;

constexpr std::string_view kLeftOut = "left out: ";  // of accountSentence()

std::string pointText(const Vec3& point) {
  // Adding zero removes the sign of a rounded zero.
  const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4 + 0.0; };
  return fmt::format("{:.4f} {:.4f} {:.4f}", rounded(point.x), rounded(point.y), rounded(point.z));
}

std::string boundsText(const Bounds& bounds) {
  if (bounds.empty()) return "no geometry";
  const Vec3 size = bounds.max - bounds.min;
  return fmt::format("{:.4f} x {:.4f} x {:.4f} m, from {} to {}", size.x, size.y, size.z,
                     pointText(bounds.min), pointText(bounds.max));
}

std::string countsText(const Model& model) {
  std::size_t mimics = 0, fixed = 0;
  for (const Joint& joint : model.joints) {
    mimics += joint.mimic ? 1 : 0;
    fixed += joint.type == JointType::fixed && !joint.mimic ? 1 : 0;
  }
  std::string text = counted(model.links.size(), "link");
  if (model.joints.empty()) return text + ", no joints";
  text += fmt::format(", {}: {} driven", counted(model.joints.size(), "joint"),
                      grouped(model.movableJoints().size()));
  if (mimics > 0) text += fmt::format(", {} mimic", grouped(mimics));
  if (fixed > 0) text += fmt::format(", {} fixed", grouped(fixed));
  return text + fmt::format("; `joints` takes {}", counted(model.positionalCount(), "value"));
}

bool turns(JointType type) { return type == JointType::revolute || type == JointType::continuous; }

std::string mimicText(const Model& model, const Joint& joint) {
  if (!joint.mimic) return {};
  std::string text = "mimics " + plainText(model.joints[joint.mimic->joint].name);
  if (joint.mimic->multiplier != 1.0) text += fmt::format(" x {:.6g}", joint.mimic->multiplier);
  if (joint.mimic->offset != 0.0) {
    text += joint.mimic->offset > 0.0 ? " +" : " ";
    text += turns(joint.type) ? angleText(joint.mimic->offset)
                              : fmt::format("{:.6g}", joint.mimic->offset);
  }
  return text;
}

std::string numberText(const Joint& joint, const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return "-";
  return turns(joint.type) ? angleText(*value) : fmt::format("{:.6g}", *value);
}

std::string lowestText(const Joint& joint) {
  return numberText(joint, joint.limits ? std::optional(joint.limits->lower) : std::nullopt);
}

std::string highestText(const Joint& joint) {
  return numberText(joint, joint.limits ? std::optional(joint.limits->upper) : std::nullopt);
}

std::string unitOf(JointType type) {
  if (type == JointType::prismatic) return "m";
  if (turns(type)) return "°";
  return type == JointType::planar ? "m, °" : type == JointType::floating ? "m" : "-";
}

/// The position in `joints`, from 1: "1", "4-6"; "-" without values.
std::string placeText(const InfoJoint& entry) {
  if (!entry.first_value) return "-";
  const std::size_t count = valueCount(entry.model->joints[entry.joint].type);
  if (count == 1) return std::to_string(*entry.first_value + 1);
  return fmt::format("{}-{}", *entry.first_value + 1, *entry.first_value + count);
}

void addJoints(std::string& out, const std::vector<InfoJoint>& joints) {
  if (joints.empty()) return;
  cli::TextTable table;
  table.is_number = {true, false, false, true, true, false, true, false, false, false};
  table.rows.push_back(
      {"value", "joint", "type", "lowest", "highest", "unit", "per s", "parent", "child", ""});
  for (const InfoJoint& entry : joints) {
    const Model& model = *entry.model;
    const Joint& joint = model.joints[entry.joint];
    table.rows.push_back({placeText(entry), plainText(joint.name), std::string(nameOf(joint.type)),
                          lowestText(joint), highestText(joint), unitOf(joint.type),
                          numberText(joint, joint.limits ? joint.limits->velocity : std::nullopt),
                          plainText(model.links[joint.parent].name),
                          plainText(model.links[joint.child].name), mimicText(model, joint)});
  }
  out += "\n" + table.text();
}

void addDevices(std::string& out, const ModelInfo& info) {
  if (!info.severalDevices() || info.devices.empty()) return;
  cli::TextTable table;
  table.is_number = {false, false, false, true, true, false};
  table.rows.push_back({"device", "model", "layer", "driven", "triangles", "stands at"});
  for (const InfoDevice& entry : info.devices) {
    const CellDevice& device = *entry.device;
    std::string where = pointText(device.pose.position);
    if (!device.on_device.empty()) {
      where += " on " + plainText(device.on_device);
      if (!device.on_link.empty()) where += "/" + plainText(device.on_link);
    }
    if (device.optional) where += " (waits for `add`)";
    table.rows.push_back({plainText(device.name), plainText(device.model),
                          device.layer.empty() ? "-" : plainText(device.layer),
                          grouped(entry.movable), grouped(entry.triangles), where});
  }
  out += "\n" + table.text();
}

void addTextures(std::string& out, const ModelInfo& info) {
  if (info.textures.empty()) return;
  cli::TextTable table;
  table.is_number = {false, true};
  table.rows.push_back({"texture", "on disk"});
  for (const InfoFile& texture : info.textures) {
    table.rows.push_back({plainText(texture.name), texture.bytes ? sizeText(*texture.bytes) : "?"});
  }
  out += "\n" + table.text();
}

/// Notes of what was left out are one sentence instead.
bool isInSentence(const Finding& fault) {
  return fault.severity == Severity::note && !fault.left_out.empty();
}

void addFaults(std::string& out, const ModelInfo& info) {
  const Findings& faults = info.cell->faults;
  if (std::ranges::all_of(faults, isInSentence)) return;
  out += "\n";
  for (const Finding& fault : faults) {
    if (isInSentence(fault)) continue;
    out += "  " + plainText(info.cell->shown(fault.print())) + "\n";
  }
}

std::string meshesText(std::uint64_t count) {
  return count == 1 ? "1 mesh" : grouped(count) + " meshes";
}

std::string missingText(const ModelInfo& info) {
  std::string text = info.meshes_missing == 0 ? "" : meshesText(info.meshes_missing);
  if (!info.textures_missing.empty()) {
    text += (text.empty() ? "" : ", ") + counted(info.textures_missing.size(), "texture");
  }
  return text.empty() ? "none" : text;
}

template <class T>
std::string namesOf(const std::vector<T>& items) {
  std::string names;
  for (const T& item : items) names += (names.empty() ? "" : ", ") + plainText(item.name);
  return names;
}

std::string faultCounts(const Findings& faults) {
  std::string text;
  for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
    const auto count = static_cast<std::size_t>(std::ranges::count_if(
        faults, [&](const auto& one) { return one.severity == severity && !isInSentence(one); }));
    if (count == 0) continue;
    text += (text.empty() ? "" : ", ") + counted(count, nameOf(severity));
  }
  return text.empty() ? "none" : text;
}

}  // namespace

std::string modelInfoText(const ModelInfo& info) {
  const Cell& cell = *info.cell;
  std::string out = plainText(cell.shown(cell.file)) + "\n";
  out += fmt::format("  name      {}\n", plainText(info.name));
  if (info.severalDevices()) {
    out += fmt::format("  devices   {} of {}\n", grouped(info.devices.size()),
                       counted(info.models.size(), "model"));
  }
  for (const Model* model : info.models) {
    if (info.severalDevices()) {
      out += fmt::format("  model     {}: {}, kin={:016x}\n",
                         plainText(model->name.empty() ? cell.shown(model->file) : model->name),
                         countsText(*model), kinematicsHash(*model));
    } else {
      out += fmt::format("  tree      {}\n  hash      kin={:016x}\n", countsText(*model),
                         kinematicsHash(*model));
    }
  }
  out += fmt::format("  size      {}\n", boundsText(info.bounds));
  out += fmt::format("  geometry  {} in {}, {} in memory\n", counted(info.triangles, "triangle"),
                     meshesText(info.meshes), sizeText(info.geometry_bytes));
  out += fmt::format("  textures  {}\n",
                     info.textures.empty() ? "none" : grouped(info.textures.size()));
  out += fmt::format("  missing   {}\n", missingText(info));
  if (!cell.cameras.empty()) out += "  cameras   " + namesOf(cell.cameras) + "\n";
  if (!cell.layers.empty()) out += "  layers    " + namesOf(cell.layers) + "\n";
  out += fmt::format("  faults    {}\n", faultCounts(cell.faults));
  if (const std::string left_out = accountSentence(accountOf(cell.faults)); !left_out.empty()) {
    out += fmt::format("  left out  {}\n", plainText(cell.shown(left_out.substr(kLeftOut.size()))));
  }
  addDevices(out, info);
  // One table per model, even if thousands of devices share it.
  std::vector<const Model*> described;
  for (const InfoDevice& device : info.devices) {
    if (device.joints.empty() || std::ranges::find(described, device.model) != described.end())
      continue;
    described.push_back(device.model);
    if (info.severalDevices()) {
      out += fmt::format("\n  {}, as {} has it:\n", plainText(device.device->model),
                         plainText(device.device->name));
    }
    addJoints(out, device.joints);
  }
  addTextures(out, info);
  addFaults(out, info);
  return out;
}

}  // namespace rocinante
