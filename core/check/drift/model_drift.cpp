#include "core/check/drift/model_drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <string_view>

#include "core/check/drift/drift_list.h"
#include "core/check/drift/joint_drift.h"
#include "core/check/drift/look_drift.h"

namespace rocinante {
namespace {

constexpr std::array<std::string_view, 4> kLookRules{"drift.collision", "drift.geometry",
                                                     "drift.material", "drift.texture"};

class CellDrift {
 public:
  CellDrift(const Cell& recorded, const Cell& given) : recorded_(recorded), given_(given) {}

  Findings find() {
    for (const CellDevice& was : recorded_.devices) compareDevice(was);
    for (const CellDevice& is : given_.devices) {
      if (recorded_.findDevice(is.name) != nullptr) continue;
      DriftList(findings_, is.name)
          .add(
              "drift.device-added",
              fmt::format("device {} is new: it would be drawn, and was not there when the session "
                          "was recorded",
                          is.name));
    }
    // Models that `add` can bring.
    for (const auto& [name, was] : recorded_.models) {
      const auto is = given_.models.find(name);
      if (is == given_.models.end()) {
        DriftList(findings_, name)
            .add("drift.model-removed",
                 fmt::format("no model is named {} any more: `add` of it would bring nothing",
                             name));
      } else {
        compareModels(was.get(), is->second.get(), name);
      }
    }
    compareLayers();
    compareCameras();
    return std::move(findings_);
  }

 private:
  void compareDevice(const CellDevice& was) {
    DriftList drift(findings_, was.name);
    const CellDevice* const is = given_.findDevice(was.name);
    if (is == nullptr) {
      drift.add(
          "drift.device-removed",
          fmt::format("device {} is gone: what the log says of it would draw nothing", was.name),
          renamedHint(was));
      return;
    }
    compareModels(recorded_.modelOf(was), given_.modelOf(*is), was.name);
    const bool same_carrier = was.on_device == is->on_device && was.on_link == is->on_link;
    const std::string moved = poseDrift(was.pose, is->pose);
    if (!same_carrier) {
      drift.add("drift.device-moved", fmt::format("device {} is mounted on {} instead of {}",
                                                  was.name, carrierText(*is), carrierText(was)));
    } else if (!moved.empty()) {
      drift.add("drift.device-moved",
                fmt::format("device {} {}: it would be drawn there until the log gives it a pose",
                            was.name, moved));
    }
    if (was.layer != is->layer) {
      drift.add("drift.layer", fmt::format("device {} is on layer `{}` instead of `{}`: what the "
                                           "log shows or hides by layer would differ",
                                           was.name, is->layer, was.layer));
    }
    if (was.tags != is->tags) {
      drift.add("drift.layer",
                fmt::format("the tags of device {} have changed: what the log shows or hides by "
                            "layer would differ",
                            was.name));
    }
    if (was.color != is->color) {
      drift.add("drift.material", fmt::format("the cell colours device {} differently", was.name));
    }
    if (was.optional != is->optional) {
      drift.add("drift.device-optional",
                is->optional ? fmt::format("device {} now waits for `add`, which the log may not "
                                           "contain",
                                           was.name)
                             : fmt::format("device {} no longer waits for `add`: it would be drawn "
                                           "before the log adds it",
                                           was.name));
    }
  }

  static std::string carrierText(const CellDevice& device) {
    if (device.on_device.empty()) return "the ground";
    return device.on_device + (device.on_link.empty() ? "" : "/" + device.on_link);
  }

  /// A hint when a new device has the model and place of this one.
  std::string renamedHint(const CellDevice& was) const {
    for (const CellDevice& is : given_.devices) {
      if (recorded_.findDevice(is.name) != nullptr || is.model != was.model) continue;
      if (poseDrift(was.pose, is.pose).empty()) {
        return fmt::format("{} is new, of the same model and in the same place: was it renamed?",
                           is.name);
      }
    }
    return "";
  }

  /// Devices share models: a pair is reported once, for its first device.
  void compareModels(const Model* was, const Model* is, const std::string& who) {
    if (was == nullptr || is == nullptr || !compared_.insert({was, is}).second) return;
    DriftList drift(findings_, who);
    const auto renamed_links = addJointDrift(*was, *is, drift);
    look_.add(*was, *is, renamed_links, drift);
  }

  void compareLayers() {
    for (const CellLayer& was : recorded_.layers) {
      for (const CellLayer& is : given_.layers) {
        if (is.name != was.name || is.members == was.members) continue;
        DriftList(findings_, was.name)
            .add("drift.layer",
                 fmt::format("the links or parts of layer {} have changed", was.name));
      }
    }
  }

  void compareCameras() {
    const auto report = [&](const std::string& name, const char* what) {
      DriftList(findings_, name).add("drift.camera", fmt::format("camera {} {}", name, what));
    };
    for (const CellCamera& was : recorded_.cameras) {
      const CellCamera* const is = given_.findCamera(was.name);
      if (is == nullptr) {
        report(was.name, "is gone");
        continue;
      }
      const bool same = was.eye == is->eye && was.target == is->target && was.up == is->up &&
                        was.fov_deg == is->fov_deg && was.ortho_height_m == is->ortho_height_m &&
                        was.on_device == is->on_device && was.on_link == is->on_link &&
                        was.follow_device == is->follow_device &&
                        was.follow_link == is->follow_link && was.look_device == is->look_device &&
                        was.look_link == is->look_link;
      if (!same) report(was.name, "has a different view");
    }
    for (const CellCamera& is : given_.cameras) {
      if (recorded_.findCamera(is.name) == nullptr) report(is.name, "is new");
    }
  }

  const Cell &recorded_, &given_;
  Findings findings_;
  std::set<std::pair<const Model*, const Model*>> compared_;
  LookDrift look_;
};

}  // namespace

Findings descriptionDrift(const Cell& described, bool has_meshes, const Cell& given) {
  const Model* const robot =
      described.devices.empty() ? nullptr : described.modelOf(described.devices.front());
  if (robot == nullptr) return {};
  const auto model = std::make_shared<const Model>(*robot);
  // The given cell with that robot in place of its own.
  Cell recorded = given;
  std::size_t meant = 0;
  for (CellDevice& device : recorded.devices) {
    const Model* const own = given.modelOf(device);
    if (own == nullptr) continue;
    if (own->name != robot->name && given.devices.size() != 1) continue;
    device.dressed = model;
    ++meant;
  }
  if (meant == 0) return {};
  Findings findings = modelDrift(recorded, given);
  if (has_meshes) return findings;
  std::erase_if(findings, [](const Finding& finding) {
    return std::ranges::find(kLookRules, finding.rule) != kLookRules.end();
  });
  return findings;
}

Findings modelDrift(const Cell& recorded, const Cell& given) {
  return CellDrift(recorded, given).find();
}

}  // namespace rocinante
