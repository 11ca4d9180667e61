#include "core/relay/echo_memory.h"

#include <algorithm>
#include <cstring>

#include "core/base/hash.h"
#include "core/packet/state_folder.h"

namespace rocinante {
namespace {

/// Ways that are remembered to bring echoes; each for kSuspicion.
constexpr std::size_t kMaxEchoing = 1024;
constexpr Nanoseconds kSuspicion = std::chrono::minutes(1);

std::uint64_t hashOf(ByteView bytes) {
  const auto digest = xxh3(bytes);
  std::uint64_t hash = 0;
  std::memcpy(&hash, digest.data(), sizeof hash);
  return hash;
}

constexpr std::string_view kThroughWord = " through=";

/// Another relay wrote these bytes, from what this one may have passed on.
bool isRewritten(const PacketHeader& header) { return header.via || !header.by.empty(); }

}  // namespace

void EchoMemory::findKeys(const Arrival& arrival) {
  const PacketHeader& header = arrival.header;
  const std::uint64_t sequence = header.sequence.value_or(0);
  const std::int64_t time = header.time_ns.value_or(-1);
  text_.assign(header.source);
  text_ += '\0';
  text_ += header.run;
  text_ += '\0';
  text_.append(reinterpret_cast<const char*>(&sequence), sizeof sequence);
  text_.append(reinterpret_cast<const char*>(&time), sizeof time);
  keys_.header = hashOf(bytesOf(text_));
  const std::string_view text = textOf(arrival.datagram);
  if (arrival.through.empty()) {
    keys_.bytes = hashOf(arrival.datagram);
    return;
  }
  const auto begin = static_cast<std::size_t>(arrival.through.data() - text.data());
  text_ = text.substr(0, begin - std::min(begin, kThroughWord.size()));
  text_ += text.substr(begin + arrival.through.size());
  keys_.bytes = hashOf(bytesOf(text_));
}

std::optional<Nanoseconds> EchoMemory::echoAfter(const Arrival& arrival,
                                                 const SessionState& state) {
  const PacketHeader& header = arrival.header;
  forget(arrival.now);
  findKeys(arrival);
  const bool is_known_way = arrival.way != kUnknownWay;
  if (const auto copy = passed_.find(keys_.bytes); copy != passed_.end() &&
                                                   !arrival.through.empty() && is_known_way &&
                                                   copy->second.way != arrival.way) {
    // Relays passed it on by two ways, and it has nothing that says which is the newer.
    noteEchoing(arrival.way, arrival.now);
    return arrival.now - copy->second.time;
  }
  if (!header.sequence) return std::nullopt;
  const Newness newness = newnessOf(state, header);
  const auto found = passed_.find(isRewritten(header) ? keys_.header : keys_.bytes);
  if (found == passed_.end()) {
    if (newness != Newness::restart || !isOlder(arrival, state)) return std::nullopt;
    return arrival.now - sources_.find(header.source)->second.time;
  }
  const bool other_way = !is_known_way || found->second.way != arrival.way;
  const Nanoseconds after = arrival.now - found->second.time;
  if (newness == Newness::late) {
    if (other_way) noteEchoing(arrival.way, arrival.now);
    return std::nullopt;
  }
  const bool goes_back = newness == Newness::restart || (header.reset && header.via);
  if (!goes_back) {
    // Newer only because a `reset` has made this relay forget.
    const auto source = sources_.find(header.source);
    const bool may_repeat = !header.by.empty() || header.reset || !is_known_way ||
                            (source != sources_.end() && source->second.reset == arrival.way);
    if (may_repeat || !other_way) return std::nullopt;
  } else if (!other_way && !isEchoing(arrival.way, arrival.now)) {
    return std::nullopt;
  }
  noteEchoing(arrival.way, arrival.now);
  return after;
}

/// An older number of what the source says now, by a longer way than the newest.
bool EchoMemory::isOlder(const Arrival& arrival, const SessionState& state) const {
  const PacketHeader& header = arrival.header;
  const auto source = sources_.find(header.source);
  const auto known = state.sources().find(header.source);
  if (source == sources_.end() || known == state.sources().end() || header.reset) return false;
  if (arrival.way == kUnknownWay || source->second.way == arrival.way) return false;
  if (arrival.now - source->second.time >= kSpan || known->second.run != header.run) return false;
  const std::optional<std::int64_t>& newest = known->second.time_ns;
  return !header.run.empty() || (header.time_ns && newest && *header.time_ns <= *newest);
}

void EchoMemory::passed(const Arrival& arrival) {
  const PacketHeader& header = arrival.header;
  if (header.by.empty() || header.reset) {
    auto found = sources_.find(header.source);
    if (found == sources_.end())
      found = sources_.emplace(std::string(header.source), Source()).first;
    found->second.way = arrival.way;
    found->second.time = arrival.now;
    if (header.reset) found->second.reset = arrival.way;
  }
  remember(keys_.bytes, {arrival.now, arrival.way});
  if (header.sequence) remember(keys_.header, {arrival.now, arrival.way});
}

void EchoMemory::remember(std::uint64_t key, const Passed& passed) {
  passed_.insert_or_assign(key, passed);
  order_.emplace_back(passed.time, key);
}

void EchoMemory::forget(LogTime now) {
  while (!order_.empty() &&
         (now - order_.front().first > kSpan || order_.size() > 2 * kDatagrams)) {
    const auto [time, key] = order_.front();
    order_.pop_front();
    const auto found = passed_.find(key);
    if (found != passed_.end() && found->second.time == time) passed_.erase(found);
  }
}

void EchoMemory::noteEchoing(ArrivalWay way, LogTime now) {
  if (way == kUnknownWay) return;
  if (echoing_.size() >= kMaxEchoing && !echoing_.contains(way)) {
    std::erase_if(echoing_, [&](const auto& each) { return now - each.second > kSuspicion; });
    if (echoing_.size() >= kMaxEchoing) return;
  }
  echoing_[way] = now;
}

bool EchoMemory::isEchoing(ArrivalWay way, LogTime now) const {
  const auto found = echoing_.find(way);
  return found != echoing_.end() ? now - found->second <= kSuspicion
                                 : echoing_.size() >= kMaxEchoing;
}

}  // namespace rocinante
