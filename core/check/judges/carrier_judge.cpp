#include "core/check/judges/carrier_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

/// Most loops that are counted separately; only a hostile session has more.
constexpr std::size_t kMaxLoops = 200;

}  // namespace

std::string_view CarrierJudge::carrierOf(std::string_view device, const SessionState& state) const {
  const DeviceState* const device_state = state.findDevice(device);
  if (device_state != nullptr && device_state->presence &&
      device_state->presence->value.presence == Presence::removed) {
    return {};
  }
  if (device_state != nullptr && device_state->pose) {
    const Path& carrier = device_state->pose->value.carrier;
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
  std::vector<std::string> loop{std::string(device)};
  for (at = carrierOf(device, state); at != device; at = carrierOf(at, state))
    loop.emplace_back(at);
  // Not std::ranges::rotate, whose answer clang 14 does not compile with the library of g++ 12.
  std::rotate(loop.begin(), std::ranges::min_element(loop), loop.end());
  auto found = loops_.find(loop);
  if (found == loops_.end() && loops_.size() == kMaxLoops) {
    others_.hit(place);
    return;
  }
  if (found == loops_.end()) found = loops_.emplace(std::move(loop), Tally()).first;
  found->second.hit(place);
}

void CarrierJudge::report(Findings& findings) const {
  for (const auto& [loop, tally] : loops_) {
    std::string text = "devices carry one another in a loop: ";
    for (const std::string& device : loop) text += plainText(device) + " on ";
    text += plainText(loop.front());
    findings.push_back(tally.finding("packet.carrier-loop", loop.front(), std::move(text)));
  }
  if (others_.count == 0) return;
  findings.push_back(
      others_.finding("packet.carrier-loop", "",
                      fmt::format("devices carry one another in more than {} loops", kMaxLoops)));
}

}  // namespace rocinante
