#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/cell/scene_pose_cache.h"
#include "core/packet/session_state.h"
#include "core/series/series_key.h"

namespace rocinante {

/// not_found, with the known names or the one that was probably meant, when neither the cell nor
/// `state` has the device or the link of a key of a link, or those of its frame.
Status checkLink(const Cell& cell, const SessionState& state, const SeriesKey& key);

/// Links as keys name them, in the world or in the frame of another device or link, in one state
/// after another: with the bits of poseScene(), and of it only what the chosen links need. The cell
/// must outlive it; its geometry is not needed. One thread.
class PlacedLinks {
 public:
  explicit PlacedLinks(const Cell& cell) : cell_(cell), poses_(cell) {}

  /// Which of poses() the key's link is; its part does not matter. The key is of a link.
  std::size_t add(const SeriesKey& key);
  /// Whether the statement may move one of them. A restatement may also, by what it leaves out.
  bool isMovedBy(const Statement& statement) const;
  /// The devices that move them, as far as place() has met them: also carriers that are not there
  /// yet, of which a few that carry nothing any more.
  const std::set<std::string, std::less<>>& devices() const { return devices_; }

  void place(const SessionState& state);
  /// As placed last, in the order of add(); empty where a device or a link is not there.
  const std::vector<std::optional<Pose>>& poses() const { return placed_; }

 private:
  void choose(const std::string& device);
  void chooseFor(const SeriesKey& link);

  const Cell& cell_;
  ScenePoseCache poses_;
  std::set<std::string, std::less<>> devices_;
  std::vector<SeriesKey> links_;  ///< without parts
  std::vector<std::optional<Pose>> placed_;
};

}  // namespace rocinante
