#include "recorder/diff/message_match.h"

#include <algorithm>
#include <bit>

#include "core/base/hash.h"

namespace rocinante {
namespace {

constexpr std::size_t kShownBytes = 160;

std::array<std::uint64_t, 2> digestOf(const LogMessage& message, bool with_topic, Bytes& scratch) {
  if (!with_topic) return std::bit_cast<std::array<std::uint64_t, 2>>(xxh3(message.payload));
  const ByteView topic = bytesOf(message.channel->topic);
  scratch.assign(topic.begin(), topic.end());
  scratch.push_back(std::byte{0});
  scratch.insert(scratch.end(), message.payload.begin(), message.payload.end());
  return std::bit_cast<std::array<std::uint64_t, 2>>(xxh3(scratch));
}

}  // namespace

bool MessageMatch::compares(std::size_t side, const LogChannel& channel) const {
  if (!chosen_) return channel.captured();
  const std::vector<bool>& chosen = (*chosen_)[side];
  return channel.id < chosen.size() && chosen[channel.id];
}

Status MessageMatch::fill(std::size_t number, std::size_t items) {
  Side& side = sides_[number];
  Bytes scratch;
  while (!side.at_end && side.ahead.size() < items) {
    const Result<std::optional<LogMessage>> message = side.reader.next();
    if (!message) return message.error();
    if (!*message) {
      side.at_end = true;
      break;
    }
    if (!compares(number, *(*message)->channel)) continue;
    const ByteView payload = (*message)->payload;
    MatchItem item;
    item.digest = digestOf(**message, !chosen_, scratch);
    item.place = {side.count++, (*message)->log_time, (*message)->channel->topic,
                  std::string(textOf(payload.first(std::min(payload.size(), kShownBytes))))};
    side.ahead.push_back(std::move(item));
  }
  return {};
}

Result<std::optional<MessageMatch::Step>> MessageMatch::next() {
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    if (Status filled = fill(side, 1); !filled) return filled.error();
  }
  auto& a = sides_[0].ahead;
  auto& b = sides_[1].ahead;
  const auto take = [](std::deque<MatchItem>& items) {
    MatchItem item = std::move(items.front());
    items.pop_front();
    return item;
  };
  if (a.empty() && b.empty()) return std::optional<Step>();
  Step step;
  if (alone_[0] == 0 && alone_[1] == 0 && !a.empty() && !b.empty() &&
      a.front().digest == b.front().digest) {
    step.a = take(a);
    step.b = take(b);
    return std::optional<Step>(std::move(step));
  }
  if (alone_[0] == 0 && alone_[1] == 0) {
    if (Status found = resynchronise(); !found) return found.error();
  }
  if (alone_[0] > 0) {
    --alone_[0];
    step.a = take(a);
  } else {
    --alone_[1];
    step.b = take(b);
  }
  return std::optional<Step>(std::move(step));
}

/// Finds the pair of equal messages ahead that skips the fewest messages. The skipped ones are in
/// one log only; without a pair, everything in the window is.
Status MessageMatch::resynchronise() {
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    if (Status filled = fill(side, kWindow); !filled) return filled;
  }
  const auto& a = sides_[0].ahead;
  const auto& b = sides_[1].ahead;
  if (!first_parting_) {
    first_parting_.emplace();
    if (!a.empty()) first_parting_->a = a.front().place;
    if (!b.empty()) first_parting_->b = b.front().place;
  }
  struct Hash {
    std::size_t operator()(const std::array<std::uint64_t, 2>& digest) const {
      return static_cast<std::size_t>(digest[0]);
    }
  };
  std::unordered_map<std::array<std::uint64_t, 2>, std::size_t, Hash> first_in_b;
  for (std::size_t j = 0; j < b.size(); ++j) first_in_b.try_emplace(b[j].digest, j);
  std::size_t best_a = a.size();
  std::size_t best_b = b.size();
  for (std::size_t i = 0; i < a.size() && i < best_a + best_b; ++i) {
    const auto found = first_in_b.find(a[i].digest);
    if (found == first_in_b.end() || i + found->second >= best_a + best_b) continue;
    best_a = i;
    best_b = found->second;
  }
  alone_ = {best_a, best_b};
  return {};
}

}  // namespace rocinante
