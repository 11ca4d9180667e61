#include "core/kinematics/visibility.h"

#include <fmt/format.h>

#include "core/base/count_text.h"

namespace rocinante {

void judgeVisibility(const Model& model, Place place, FaultList& faults) {
  std::uint64_t with_collisions = 0;
  for (const Link& link : model.links) {
    if (!link.visuals.empty()) return;
    with_collisions += link.collisions.empty() ? 0 : 1;
  }
  if (with_collisions == 0) return;
  faults.warning("model.no-visual", place,
                 fmt::format("nothing of the model is drawn: {} collision geometry, and none has a "
                             "<visual>",
                             with_collisions == 1 ? std::string("1 link has")
                                                  : countText(with_collisions, "link") + " have"),
                 "to see it: render --collision '*', C in the window, or collision = \"only\" in a "
                 "[[layer]] of a cell");
}

}  // namespace rocinante
