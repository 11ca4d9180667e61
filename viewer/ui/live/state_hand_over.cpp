#include "viewer/ui/live/state_hand_over.h"

#include <algorithm>
#include <utility>

namespace rocinante {
namespace {

/// Folding this many bytes of packets takes less than a tenth of a millisecond.
constexpr std::uint64_t kFewBytes = std::uint64_t{16} << 10U;
/// Folding a byte of packets takes as long as copying this many bytes of a state.
constexpr std::uint64_t kCopiedBytes = 4;

}  // namespace

bool StateChanges::add(LogTime time, ByteView packet, const SessionState& state) {
  const std::uint64_t most = std::max(kFewBytes, state.weight() / kCopiedBytes);
  if (bytes_.size() + packet.size() > most) return false;
  packets_.push_back(
      {time, static_cast<std::uint32_t>(bytes_.size()), static_cast<std::uint32_t>(packet.size())});
  bytes_.insert(bytes_.end(), packet.begin(), packet.end());
  return true;
}

void StateChanges::replaceBy(const SessionState& state) {
  clear();
  whole_ = state;
}

void StateChanges::applyTo(SessionState& state, Decoder& decoder) && {
  if (whole_) state = *std::exchange(whole_, std::nullopt);
  for (const Packet& each : packets_) {
    const auto* const packet = decoder.decode(ByteView(bytes_).subspan(each.offset, each.length));
    if (packet != nullptr) state.apply(each.time, *packet);
  }
  // Those of the session are read from its log.
  if (!packets_.empty()) (void)state.takeEvents();
  packets_.clear();
  bytes_.clear();
}

void StateChanges::clear() {
  whole_.reset();
  packets_.clear();
  bytes_.clear();
}

}  // namespace rocinante
