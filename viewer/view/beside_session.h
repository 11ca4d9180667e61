#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/behaviour/run_spec.h"
#include "core/cell/posed_scene.h"
#include "core/cell/scene_pose_cache.h"
#include "core/session/event_alignment.h"
#include "core/session/timeline.h"
#include "viewer/view/render_style.h"

namespace rocinante {

/// In front of a device's name: that device in the session beside ("beside:arm").
inline constexpr std::string_view kBesidePrefix = "beside:";

/// How times of a session are aligned with those of the one beside it, by docs/programs/render.md,
/// section "A second session": "origin", "events", "event:TEXT", or an offset, as "2.5s".
/// bad_argument when the text is none of these, or the sessions have no such event in common.
/// Damage that may hide events is added to `damage`.
Result<EventAlignment> alignBeside(std::string_view how, Timeline& shown, Timeline& beside,
                                   StateDamage& damage);

/// Another session of a cell, shown as ghosts beside the first: every device that is elsewhere in
/// it than in the shown scene at that very moment. A function of both states alone. Not
/// thread-safe; borrows the cell.
class BesideSession {
 public:
  /// A device is elsewhere when one of its links is farther away than this, or turned by more: the
  /// floors of a run.
  static constexpr double kSamePlace_m = kRunFloors.position_mm / 1000;
  static constexpr double kSameTurn_deg = kRunFloors.turn_deg;

  BesideSession(const Cell& cell, Timeline session, EventAlignment alignment)
      : poses_(cell), session_(std::move(session)), alignment_(std::move(alignment)) {}

  /// The moment of this session beside that one of the shown session.
  LogTime momentAt(LogTime shown) const { return alignment_.inB(shown); }
  /// Whether this session has that moment; without it there are no ghosts.
  bool covers(LogTime shown) const;

  /// Appends the ghosts to `scene`, which is of the moment `shown`; they are valid until the next
  /// call. Damage of this session's log is added to `damage`.
  Status addGhosts(PosedScene& scene, LogTime shown, StateDamage& damage);

  const EventAlignment& alignment() const { return alignment_; }
  Timeline& session() { return session_; }
  const Timeline& session() const { return session_; }

 private:
  ScenePoseCache poses_;
  Timeline session_;
  EventAlignment alignment_;
};

/// Makes all ghosts clear, those of the cell too: as a picture with a session beside has them.
inline void setBesideLook(RenderStyle& style) { style.ghosts = GhostStyle::clear; }

/// Whether every link of a device is where it is in the other scene, within the limits above.
bool isSamePlace(const PosedDevice& a, const PosedDevice& b);

}  // namespace rocinante
