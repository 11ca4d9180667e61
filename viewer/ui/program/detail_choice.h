#pragma once

#include <optional>
#include <string>

#include "viewer/detail/governor.h"
#include "viewer/render/renderer.h"
#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {

/// The rung of detail of a window's frames: chosen by the user, or by the governor from what frames
/// cost. Main thread.
class DetailChoice {
 public:
  /// `fixed`: empty: the governor's, where it `may_govern`, else rung 0.
  DetailChoice(std::optional<int> fixed, bool may_govern, double target_fps);

  int rung() const { return rung_; }
  /// Looks that are the window's own choice are left out: as long as a machine cannot draw them in
  /// time, and with a level that the user chose.
  bool dropsLooks() const { return fixed_ ? rung_ > 0 : !governor_.drawsLooks(); }
  /// Whether there are such looks.
  void setLooksByDefault(bool any);
  bool fixed() const { return fixed_; }

  /// Starts coarser meshes when first needed, or at once if the governor may need them. A level
  /// chosen by number waits for its meshes before the first frame. True when there are new ones.
  bool prepare(Renderer& renderer);
  /// Takes what the user asked for.
  void apply(const ViewerRequests& requests);
  void frameDrawn(double cost_ms);
  /// Begins where a frame should be in time, by the cost of one on `rung` without dear looks.
  void begin(int rung, double cost_ms);
  /// Begins on that rung, without dear looks.
  void beginAt(int rung);
  double targetMs() const { return 1000 / target_fps_; }
  /// A frame that took so long that its look is not drawn any more, if there was one.
  std::optional<Governor::Runaway> takeRunaway() { return governor_.takeRunaway(); }
  /// What is drawn changed: size, meshes.
  void forget() { governor_.forget(); }
  void tell(ViewerStatus& status) const;

 private:
  Governor governor_;
  double target_fps_;
  bool may_govern_;
  bool fixed_;
  int rung_ = 0;
  bool coarse_ready_ = true;
  bool looks_by_default_ = false;
};

/// One sentence about a look that is not drawn any more.
std::string runawayText(const Governor::Runaway& runaway);

}  // namespace rocinante
