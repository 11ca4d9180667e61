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

void UnfitValues::leaveOutUnread(const CountsBySource& counts, const CountsBySource& before) {
  const auto leaveOut = [&](const char* kind, std::string_view name, std::string reason,
                            std::uint64_t count, Severity severity) {
    if (count == 0) return;
    track_.left_out.leaveOut({kind, std::string(name), std::move(reason), {}, count, severity});
  };
  for (const auto& [source, now] : counts) {
    const auto found = before.find(source);
    const SourceCounts first = found == before.end() ? SourceCounts{} : found->second;
    for (std::size_t i = 0; i < kPacketFaultCount; ++i) {
      const auto fault = static_cast<PacketFault>(i);
      if (fault == PacketFault::unnormalised_quaternion) continue;  // it is applied
      leaveOut("line", nameOf(fault), "source " + source + " sent what packets cannot state",
               now.faults[i] - first.faults[i], Severity::warning);
    }
    const std::uint64_t late = now.late - now.duplicates;
    leaveOut("packet", "late", "of source " + source + ", behind newer ones",
             late - (first.late - first.duplicates), Severity::note);
  }
}

void UnfitValues::leaveOut(const char* kind, std::string name, std::string reason, LogTime first) {
  if (!known_.insert(name + "\n" + reason).second) return;
  track_.left_out.leaveOut({kind, std::move(name), std::move(reason),
                            fmt::format("{:.3f} s", secondsOf(first - track_.origin)), 1,
                            Severity::warning});
}

}  // namespace rocinante
