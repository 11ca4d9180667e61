#include "core/behaviour/unfit_values.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/figure_text.h"

namespace rocinante {

bool UnfitValues::takesValues(const std::string& device, const Model& model,
                              const DeviceState& state) {
  bool takes = false;
  if (state.joints) {
    const std::size_t count = state.joints->value.size();
    takes = count == model.positionalCount();
    if (!takes) {
      leaveOut("value", device,
               fmt::format("it states {}, its model takes {}", countText(count, "value"),
                           model.positionalCount()),
               state.last_write);
    }
  }
  for (const auto& [name, item] : state.named_joints) {
    if (model.findJointValue(name)) {
      takes = true;
    } else {
      leaveOut("value", device + "/" + name, "its model has no such joint", state.last_write);
    }
  }
  return takes;
}

void UnfitValues::leaveOut(const char* kind, std::string name, std::string reason, LogTime first) {
  if (!known_.insert(name + "\n" + reason).second) return;
  track_.left_out.leaveOut({kind, std::move(name), std::move(reason),
                            fmt::format("{:.3f} s", secondsOf(first - track_.origin)), 1,
                            Severity::warning});
}

}  // namespace rocinante
