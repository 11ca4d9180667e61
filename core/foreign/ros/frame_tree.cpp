#include "core/foreign/ros/frame_tree.h"

#include <cmath>

#include "core/base/plain_text.h"
#include "core/foreign/ros/names.h"
#include "core/math/transform.h"

namespace rocinante::ros {

bool isFinite(const Vec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

std::optional<std::size_t> FrameTree::frameOf(std::string_view name) {
  if (const auto known = by_name_.find(name); known != by_name_.end()) return known->second;
  if (frames_.size() >= kMaxFrames || !isName(name)) return std::nullopt;
  const std::size_t frame = frames_.size();
  Frame& made = frames_.emplace_back();
  made.name = name;
  findLink(made);
  by_name_.emplace(name, frame);
  if (made.device) device_frames_.push_back(frame);
  return frame;
}

void FrameTree::findLink(Frame& frame) {
  frame.device = devices_.deviceOfFrame(frame.name);
  frame.link = devices_.linkOfFrame(frame.name);
  if (frame.link && frame.name == frame.link->link) prefixes_.try_emplace(frame.link->device);
  if (frame.device || frame.link || !devices_.knowsDevices()) return;
  const std::optional<DeviceFinder::PrefixedLink> found = devices_.prefixedLinkOf(frame.name);
  if (!found) return;
  if (!found->is_named) {
    // Of two robots of one model the first is the device: it cannot be in two places.
    const auto [known, is_new] =
        prefixes_.try_emplace(found->link.device, std::string(found->prefix));
    if (!is_new && known->second != found->prefix) {
      frame.other_prefix = found->link.device;
      return;
    }
  }
  frame.link = found->link;
  if (found->is_root) frame.device = found->link.device;
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
  ++frame.transforms;
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
    here.used = true;
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

std::optional<FrameTree::Place> FrameTree::placeOf(std::string_view frame) {
  bool moved = false;
  const std::optional<std::size_t> known = frameOf(frame);
  return known ? placeOf(*known, {}, moved) : Place{};
}

std::optional<FrameTree::Place> FrameTree::placeIn(std::string_view frame, const Pose& pose,
                                                   std::string_view own) {
  const std::optional<Quat> turn = normalized(pose.orientation);
  if (!turn || !isFinite(pose.position)) return std::nullopt;
  const Pose inner{pose.position, *turn};
  bool moved = false;
  const std::optional<std::size_t> known = frameOf(frame);
  std::optional<Place> place = known ? placeOf(*known, own, moved) : Place{};
  if (place) place->pose = composed(place->pose, inner);
  return place;
}

std::optional<DeviceFinder::Link> FrameTree::ownerOf(std::string_view frame) {
  if (!devices_.knowsDevices()) return std::nullopt;
  const std::optional<std::size_t> known = frameOf(frame);
  if (!known) return std::nullopt;
  const Frame& found = frames_[*known];
  if (found.device) return DeviceFinder::Link{*found.device, {}};
  return found.link;
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

Account FrameTree::account() const {
  Account account;
  for (const Frame& frame : frames_) {
    // Those of a link are never asked for: whatever hangs on it is carried by it.
    const bool is_inner = frame.link && !frame.device;
    if (frame.transforms == 0 || (frame.used && !is_inner)) continue;
    LeftOut left_out{.kind = "transform", .count = frame.transforms};
    if (is_inner) {
      left_out.name = frame.link->device;
      left_out.reason = "of links within the device, which its joints move";
      left_out.first = frame.name;
    } else if (!frame.other_prefix.empty()) {
      left_out.name = frame.name;
      left_out.reason = "the frame has another prefix than the first frame of " +
                        frame.other_prefix + ", `" + prefixes_.find(frame.other_prefix)->second +
                        "`";
      left_out.severity = Severity::warning;
    } else {
      left_out.name = frame.name;
      left_out.reason = "no device's root, and nothing hangs on the frame";
    }
    account.leaveOut(std::move(left_out));
  }
  return account;
}

}  // namespace rocinante::ros
