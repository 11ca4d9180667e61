#include "core/check/judges/carrier_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace rocinante {
namespace {

/// Most loops that are counted separately; only a hostile session has more.
constexpr std::size_t kMaxLoops = 200;

}  // namespace

std::string_view CarrierJudge::carrierOf(std::string_view device, const SessionState& state) const {
  const DeviceState* const said = state.findDevice(device);
  if (said != nullptr && said->presence && said->presence->value.presence == Presence::removed) {
    return {};
  }
  if (said != nullptr && said->pose) {
    const Path& carrier = said->pose->value.carrier;
    return carrier.is_layer ? std::string_view() : carrier.first;
  }
  const CellDevice* const of_cell = cell_.findDevice(device);
  return of_cell == nullptr ? std::string_view() : std::string_view(of_cell->on_device);
}

void CarrierJudge::judge(std::string_view device, const SessionState& state,
                         const PacketPlace& place) {
  // What walks half as fast is met in a loop that the device only stands on.
  std::string_view at = carrierOf(device, state), slow = device;
  for (std::size_t i = 0; !at.empty() && at != device && at != slow; ++i) {
    at = carrierOf(at, state);
    if (i % 2 == 1) slow = carrierOf(slow, state);
  }
  if (at != device) return;
  std::vector<std::string_view> loop{device};
  for (at = carrierOf(device, state); at != device; at = carrierOf(at, state)) loop.push_back(at);
  std::ranges::rotate(loop, std::ranges::min_element(loop));
  std::string text;
  for (const std::string_view each : loop) text += fmt::format("{} on ", each);
  text += loop.front();
  auto found = loops_.find(text);
  if (found == loops_.end()) {
    if (loops_.size() == kMaxLoops) return;
    found = loops_.emplace(std::move(text), Tally()).first;
  }
  found->second.hit(place);
}

void CarrierJudge::report(Findings& findings) const {
  for (const auto& [loop, tally] : loops_) {
    findings.push_back(tally.finding("packet.carrier-loop", loop.substr(0, loop.find(' ')),
                                     fmt::format("devices carry one another in a loop: {}", loop)));
  }
}

}  // namespace rocinante
