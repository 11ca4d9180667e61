#include "core/series/placed_links.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/name_hint.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

/// Names that a hostile session gives its carriers are forgotten beyond this.
constexpr std::size_t kMostCarriers = 1024;

/// The device is there, in a model with that link; an empty link is that of the device itself.
Status checkPlace(const Cell& cell, const PosedScene& scene, const std::string& device,
                  const std::string& link) {
  const CellDevice* const of_cell = cell.findDevice(device);
  const PosedDevice* const posed = scene.findDevice(device);
  const Model* const model = posed != nullptr     ? posed->model
                             : of_cell != nullptr ? cell.modelOf(*of_cell)
                                                  : nullptr;
  if (posed == nullptr && of_cell == nullptr) {
    std::vector<std::string_view> names;
    for (const PosedDevice& each : scene.devices) names.push_back(each.name);
    return Error{ErrorKind::not_found,
                 fmt::format("no device is named `{}`: {}", device, whatThereIs(device, names)),
                 ""};
  }
  if (link.empty() || (model != nullptr && model->findLink(link))) return {};
  std::vector<std::string_view> names;
  if (model != nullptr) {
    for (const Link& each : model->links) names.push_back(each.name);
  }
  return Error{ErrorKind::not_found,
               fmt::format("`{}` has no link `{}`: {}", device, link, whatThereIs(link, names)),
               ""};
}

}  // namespace

Status checkLink(const Cell& cell, const SessionState& state, const SeriesKey& key) {
  const PosedScene scene = poseScene(cell, state);
  if (Status there = checkPlace(cell, scene, key.name, key.link); !there) return there;
  return key.frame.empty() ? Status() : checkPlace(cell, scene, key.frame, key.frame_link);
}

void PlacedLinks::choose(const std::string& device) {
  devices_.insert(device);
  // A ghost is placed like its original until a packet moves it.
  for (const CellSource& source : cell_.sources) {
    const auto ghost = source.ghost_of.find(device);
    if (ghost != source.ghost_of.end()) devices_.insert(ghost->second);
  }
}

void PlacedLinks::chooseFor(const SeriesKey& link) {
  choose(link.name);
  if (!link.frame.empty()) choose(link.frame);
}

std::size_t PlacedLinks::add(const SeriesKey& key) {
  SeriesKey link = key;
  link.part.clear();
  const auto found = std::ranges::find(links_, link);
  if (found != links_.end()) return static_cast<std::size_t>(found - links_.begin());
  chooseFor(link);
  links_.push_back(std::move(link));
  placed_.emplace_back();
  return links_.size() - 1;
}

bool PlacedLinks::isMovedBy(const Statement& statement) const {
  return movesDevice(statement.kind) && devices_.contains(statement.name);
}

void PlacedLinks::place(const SessionState& state) {
  if (devices_.size() > kMostCarriers + 4 * links_.size()) {
    devices_.clear();
    for (const SeriesKey& link : links_) chooseFor(link);
  }
  const PosedScene scene = poses_.places(state, devices_);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const SeriesKey& key = links_[i];
    placed_[i].reset();
    const auto place = scene.find(key.name, key.link);
    if (!place) continue;
    if (key.frame.empty()) {
      placed_[i] = poseOf(*place);
    } else if (const auto frame = scene.find(key.frame, key.frame_link)) {
      placed_[i] = poseOf(inverseOfRigid(*frame) * *place);
    }
  }
}

}  // namespace rocinante
