#include "core/foreign/ros/frame_tree.h"

#include <cmath>

#include "core/base/plain_text.h"
#include "core/foreign/ros/names.h"
#include "core/math/transform.h"

namespace rocinante::ros {
namespace {

bool isFinite(const Vec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

}  // namespace

std::optional<std::size_t> FrameTree::frameOf(std::string_view name) {
  if (const auto known = by_name_.find(name); known != by_name_.end()) return known->second;
  if (frames_.size() >= kMaxFrames || !isName(name)) return std::nullopt;
  const std::size_t frame = frames_.size();
  Frame& made = frames_.emplace_back();
  made.name = name;
  made.device = devices_.deviceOfFrame(name);
  made.link = devices_.linkOfFrame(name);
  by_name_.emplace(name, frame);
  if (made.device) device_frames_.push_back(frame);
  return frame;
}

FrameTree::Taken FrameTree::place(std::string_view parent, std::string_view child, const Pose& pose,
                                  Origin origin) {
  const std::optional<Quat> turn = normalized(pose.orientation);
  if (!turn || !isFinite(pose.position) || parent == child) return Taken::refused;
  const std::optional<std::size_t> above = frameOf(parent);
  const std::optional<std::size_t> below = frameOf(child);
  if (!above || !below) return Taken::refused;
  Frame& frame = frames_[*below];
  if (frame.origin > origin) return Taken::overruled;
  // Two odometries of one frame: the first.
  if (origin == Origin::odometry && frame.origin == origin && frame.parent != above) {
    return Taken::overruled;
  }
  frame.parent = above;
  frame.pose = {pose.position, *turn};
  frame.origin = origin;
  if (!frame.moved) moved_.push_back(*below);
  frame.moved = true;
  return Taken::yes;
}

std::optional<FrameTree::Place> FrameTree::placeOf(std::size_t frame, std::string_view own,
                                                   bool& moved) const {
  Place place;
  std::size_t at = frame;
  for (std::size_t depth = 0; depth < kMaxFrameDepth; ++depth) {
    const Frame& here = frames_[at];
    // A link moves with its device's joints, whatever tf says of it.
    if (here.link && here.link->device != own) {
      place.device = here.link->device;
      place.link = here.link->link;
      return place;
    }
    if (!here.parent) return place;
    moved = moved || here.moved;
    place.pose = depth == 0 ? here.pose : composed(here.pose, place.pose);
    at = *here.parent;
  }
  return std::nullopt;
}

std::optional<FrameTree::Place> FrameTree::placeOf(std::string_view frame) const {
  const auto known = by_name_.find(frame);
  bool moved = false;
  if (known != by_name_.end()) return placeOf(known->second, {}, moved);
  Place place;
  if (const std::optional<DeviceFinder::Link> link = devices_.linkOfFrame(frame)) {
    place.device = link->device;
    place.link = link->link;
  }
  return place;
}

std::optional<FrameTree::Place> FrameTree::placeIn(std::string_view frame, const Pose& pose,
                                                   std::string_view own) const {
  const std::optional<Quat> turn = normalized(pose.orientation);
  if (!turn || !isFinite(pose.position)) return std::nullopt;
  const Pose inner{pose.position, *turn};
  const auto known = by_name_.find(frame);
  bool moved = false;
  std::optional<Place> place;
  if (known != by_name_.end()) {
    place = placeOf(known->second, own, moved);
  } else {
    place = placeOf(frame);
    if (place && place->device == own) place = Place{};
  }
  if (place) place->pose = composed(place->pose, inner);
  return place;
}

std::vector<FrameTree::Moved> FrameTree::takeMoved() {
  std::vector<Moved> all;
  for (const std::size_t frame : device_frames_) {
    if (!frames_[frame].parent) continue;
    bool moved = false;
    std::optional<Place> place = placeOf(frame, *frames_[frame].device, moved);
    if (moved && place) all.push_back({&*frames_[frame].device, std::move(*place)});
  }
  for (const std::size_t frame : moved_) frames_[frame].moved = false;
  moved_.clear();
  return all;
}

}  // namespace rocinante::ros
