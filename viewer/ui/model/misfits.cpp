#include "viewer/ui/model/misfits.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/figure_text.h"
#include "core/base/name_hint.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

/// Most hints; more would take too long.
constexpr std::size_t kMaxHints = 20;

bool isRemoved(const DeviceState& state) {
  return state.presence && state.presence->value.presence == Presence::removed;
}

std::string whyUnseen(const Cell& cell, const std::string& name, const DeviceState& state,
                      bool with_hint) {
  const CellDevice* device = cell.findDevice(name);
  if (state.presence && device == nullptr) {
    return fmt::format("was added with the model `{}`, which is not in the cell",
                       state.presence->value.model);
  }
  if (device != nullptr) return {};  // waits for its `add`, or its model is unreadable
  std::string what = "is not a device of the cell and was not added";
  if (!with_hint) return what;
  std::vector<std::string_view> known;
  for (const CellDevice& one : cell.devices) known.emplace_back(one.name);
  const std::string hint = didYouMean(name, known);
  return hint.empty() ? what : what + ": " + hint;
}

std::string whatDoesNotFit(const Model& model, const DeviceState& state) {
  if (state.joints) {
    const std::size_t came = state.joints->value.size();
    const std::size_t wanted = model.positionalCount();
    if (came != wanted) {
      return fmt::format("received {}, but its model has {}, so none is used",
                         countText(came, "joint value"), wanted);
    }
  }
  for (const auto& [joint, value] : state.named_joints) {
    if (!model.findJointValue(joint)) return fmt::format("has no joint `{}`", joint);
  }
  return {};
}

}  // namespace

std::vector<Misfit> mismatchedDevices(const Cell& cell, const PosedScene& scene,
                                      const SessionState& state) {
  std::vector<Misfit> found;
  for (const auto& [name, device] : state.devices()) {
    if (isRemoved(device)) continue;
    const PosedDevice* posed = scene.findDevice(name);
    std::string what = posed == nullptr ? whyUnseen(cell, name, device, found.size() < kMaxHints)
                                        : whatDoesNotFit(*posed->model, device);
    if (!what.empty()) found.push_back({name, std::move(what)});
  }
  return found;
}

std::string whyNoSession(const Cell& cell, const SessionState& last) {
  if (last.sources().empty() && last.devices().empty()) return "has no packets";
  if (!cell.bare_model.empty()) return {};  // any device fits
  const std::vector<Misfit> found = mismatchedDevices(cell, poseScene(cell, last), last);
  const bool fits = std::ranges::any_of(last.devices(), [&](const auto& named) {
    const DeviceState& device_state = named.second;
    const bool is_moved =
        device_state.pose || device_state.joints || !device_state.named_joints.empty();
    return is_moved && std::ranges::find(found, named.first, &Misfit::device) == found.end();
  });
  if (fits || found.empty()) return {};
  return fmt::format("moves nothing of this cell: {} {}", plainText(found.front().device),
                     found.front().what);
}

}  // namespace rocinante
