#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/cell/view_path.h"
#include "core/session/timeline.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/render_style.h"

namespace rocinante {

/// Finds trails: where a link was over [time - window, time], as a function of cell, log and time
/// alone. A trail has at most kTrailPoints points whatever the rate and the window: the link's
/// place at the multiples of window / kTrailPoints since the session's origin, so that they stay
/// where they are while time goes on, and at `time` itself. Places found once are remembered, which
/// changes the cost and nothing else. One thread; borrows the cell.
class TrailFinder {
 public:
  static constexpr int kTrailPoints = 240;

  explicit TrailFinder(const Cell& cell) : cell_(cell) {}

  /// In the order of `styles`; one that names nothing has no runs. Asks `session` for states: one
  /// that was borrowed from it before is not valid any more. What places may lack, because the log
  /// is damaged, is added to `damage`.
  Result<std::vector<Trail>> find(const std::vector<TrailStyle>& styles, Timeline& session,
                                  LogTime time, StateDamage& damage);

 private:
  using Place = std::optional<Vec3>;  ///< empty: it is not there, or stands at no finite place
  /// Of one PATH and one step, by sample number.
  struct KnownPlace {
    Place place;
    bool is_damaged = false;  ///< asked for anew each time, for what it lacks
  };
  using Known = std::map<std::int64_t, KnownPlace>;

  struct Wanted {
    ViewPath path;
    Known* known = nullptr;
    Nanoseconds step{};
    std::int64_t first = 0, last = -1;  ///< samples in the window, before `time`
  };

  Status findPlaces(const std::vector<Wanted>& wanted, Timeline& session, StateDamage& damage);
  Place placeOf(const ViewPath& path, const SessionState& state);
  /// Adds to `part_` what the device stands on, and so on: posing the whole cell for one link
  /// would cost a large one dearly.
  void need(const std::string& device, const SessionState& state);

  const Cell& cell_;
  Cell part_;  ///< the devices that trails need
  std::set<std::string, std::less<>> needed_;
  std::map<std::pair<std::string, std::int64_t>, Known> known_;  ///< by PATH and step
};

}  // namespace rocinante
