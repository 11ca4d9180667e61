#include "core/session/state_cache.h"

#include <limits>

namespace rocinante {
namespace {

/// Folding this many messages takes about half a millisecond, too short to notice.
constexpr std::uint64_t kInterval = 1024;
/// Copying this many bytes of state takes about as long as folding a message.
constexpr std::uint64_t kBytesAMessage = 64;
/// States used in the last calls, up to this many, are likely to be needed next.
constexpr std::uint64_t kRecentCalls = 64;

std::uint64_t bytesOfState(const SessionState& state) {
  return sizeof(StateCache::Kept) + state.weight();
}

}  // namespace

std::uint64_t StateCache::interval(const SessionState& state) {
  return kInterval + state.weight() / kBytesAMessage;
}

void StateCache::keep(LogPosition place, const SessionState& state, LogPosition base,
                      std::uint64_t messages) {
  const auto [kept, is_new] = kept_.try_emplace(place);
  kept->second.used = ++calls_;
  if (!is_new) return;
  kept->second.state = state;
  kept->second.base = base;
  kept->second.messages = messages;
  bytes_ += bytesOfState(state);
  while (kept_.size() > 1 && (kept_.size() > kMaxStates || bytes_ > kMaxBytes)) dropOne();
}

const std::pair<const LogPosition, StateCache::Kept>* StateCache::nearest(LogPosition place) {
  const auto later = kept_.upper_bound(place);
  if (later == kept_.begin()) return nullptr;
  const auto found = std::prev(later);
  found->second.used = ++calls_;
  return &*found;
}

void StateCache::dropOne() {
  auto best = kept_.end();
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  const Kept* before = nullptr;
  for (auto each = kept_.begin(); each != kept_.end(); ++each) {
    const Kept& kept = each->second;
    const bool same_way = before != nullptr && before->base == kept.base;
    std::uint64_t cost = kept.messages - (same_way ? before->messages : 0);
    before = &kept;
    // Recently used ones are dropped only when nothing else is left.
    constexpr std::uint64_t kDear = std::numeric_limits<std::uint64_t>::max() / 2;
    if (kept.used + kRecentCalls > calls_) cost = kDear + kept.used;
    if (cost >= least) continue;
    least = cost;
    best = each;
  }
  bytes_ -= bytesOfState(best->second.state);
  kept_.erase(best);
}

}  // namespace rocinante
