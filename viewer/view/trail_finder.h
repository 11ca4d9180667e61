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

/// Finds trails: the positions of a link over [time - window, time], as a function only of cell,
/// log and time. A trail has at most kTrailPoints points for any rate and window: the link's
/// position at multiples of window / kTrailPoints since the session's origin, so that points do not
/// move as time advances, and at `time` itself. Caches positions, which only affects the cost. Not
/// thread-safe; borrows the cell.
class TrailFinder {
 public:
  static constexpr int kTrailPoints = 240;

  explicit TrailFinder(const Cell& cell) : cell_(cell) {}

  /// Trails in the order of `styles`; an unknown PATH has no runs. Queries `session`, which
  /// invalidates a state borrowed from it before. Damage of the log that affects positions is added
  /// to `damage`.
  Result<std::vector<Trail>> find(const std::vector<TrailStyle>& styles, Timeline& session,
                                  LogTime time, StateDamage& damage);

 private:
  using Place = std::optional<Vec3>;  ///< empty: absent, or not finite
  /// Positions of one PATH and step, by sample number.
  struct KnownPlace {
    Place place;
    bool is_damaged = false;  ///< queried again each time, for its damage
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
  /// Adds the device and its chain of carriers to `part_`: posing a whole large cell for one link
  /// would be slow.
  void need(const std::string& device, const SessionState& state);

  const Cell& cell_;
  Cell part_;  ///< the devices that trails need
  std::set<std::string, std::less<>> needed_;
  std::map<std::pair<std::string, std::int64_t>, Known> known_;  ///< by PATH and step
};

}  // namespace rocinante
