#include "core/relay/relay.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/relay/through.h"

namespace rocinante {
namespace {

/// After `reset` the outputs restate at once, but not more often than this.
constexpr Nanoseconds kLeastBetweenRestatements = std::chrono::milliseconds(250);
constexpr Nanoseconds kTurn = std::chrono::milliseconds(1);

}  // namespace

Relay::Relay(Options options)
    : options_(std::move(options)), encoded_name_(encodeName(options_.name)) {}

Relay::OutputId Relay::open(RelayOutputOptions options, LogTime now) {
  const OutputId id = ++last_output_;
  Output& output = outputs_[id];
  OutputHeader::Options header;
  header.relay = options_.name;
  if (options.isWhole()) {
    output.header.emplace(std::move(header));
    ++whole_;
    return id;
  }
  header.output = std::to_string(id);
  output.is_slow = options.bytes_per_second.has_value();
  output.filtered =
      std::make_unique<FilteredOutput>(OutputHeader(std::move(header)), std::move(options), now);
  output.next_restatement = now + options_.restate;
  due_ = std::min(due_, output.next_restatement);
  return id;
}

void Relay::close(OutputId output) {
  const auto found = outputs_.find(output);
  if (found == outputs_.end()) return;
  if (found->second.filtered == nullptr) --whole_;
  outputs_.erase(found);
}

std::uint64_t Relay::conflated(OutputId output) const {
  const auto& filtered = outputs_.at(output).filtered;
  return filtered == nullptr ? 0 : filtered->conflated();
}

FilteredOutCounts Relay::filteredOut(OutputId output) const {
  const auto& filtered = outputs_.at(output).filtered;
  return filtered == nullptr ? FilteredOutCounts() : filtered->filteredOut();
}

PacedCounts Relay::paced(OutputId output) const {
  const auto& filtered = outputs_.at(output).filtered;
  return filtered == nullptr ? PacedCounts() : filtered->paced();
}

void Relay::greet(OutputId output) {
  outputs_.at(output).is_waiting = true;
  due_ = LogTime::min();
}

void Relay::clearOutgoing() {
  outgoing_.clear();
  texts_.clear();
}

void Relay::send(OutputId output, std::vector<std::string>& texts) {
  for (std::string& text : texts) {
    if (options_.sign) text = textOf(options_.sign(bytesOf(text)));
    texts_.push_back(std::move(text));
    outgoing_.push_back({output, bytesOf(texts_.back())});
  }
  texts.clear();
}

std::string RelayLoop::text() const {
  constexpr std::string_view kDropped = "what comes back is dropped and counted as looped";
  if (!after) {
    return fmt::format("this relay hears itself: its own datagrams about {} come back; {}", source,
                       kDropped);
  }
  return fmt::format(
      "datagrams of {} that this relay passed on come back after {:.3f} s: relays form a loop, or "
      "the source is heard by two ways; {}",
      source, secondsOf(*after), kDropped);
}

bool Relay::namesThis(const PacketHeader& header, std::string_view through) const {
  if (header.by == options_.name || hasPassed(through, encoded_name_)) return true;
  if (!header.via) return false;
  const std::string_view relay = header.via->relay;
  return relay.size() > options_.name.size() && relay.starts_with(options_.name) &&
         relay[options_.name.size()] == ':';
}

bool Relay::isLooped(const EchoMemory::Arrival& arrival, std::string_view through) {
  std::optional<Nanoseconds> after;
  const bool is_own = namesThis(arrival.header, through);
  if (!is_own && !isTooLong(through)) after = echoes_.echoAfter(arrival, state_);
  if (!loop_ && (is_own || after)) loop_ = {std::string(arrival.header.source), after};
  return is_own || after || isTooLong(through);
}

/// Kept for what this relay says of the source itself: otherwise two relays that listen to each
/// other would not recognise their own words.
void Relay::noteThrough(std::string_view source, std::string_view through) {
  const auto known = through_.find(source);
  if (through.empty()) {
    if (known != through_.end()) through_.erase(known);
  } else if (known == through_.end()) {
    through_.emplace(source, through);
  } else if (known->second != through) {
    known->second = through;
  }
}

void Relay::receive(ByteView datagram, LogTime now, ArrivalWay way) {
  ++counts_.received;
  const Packet* const packet = decoder_.decode(datagram);
  if (packet == nullptr) {
    ++counts_.other;
    return;
  }
  const std::string_view through = throughOf(textOf(datagram));
  const EchoMemory::Arrival arrival{datagram, packet->header, through, way, now};
  if (isLooped(arrival, through)) {
    ++counts_.looped;
    return;
  }
  switch (state_.apply(now, *packet)) {
    case Applied::late:
      ++counts_.late;
      return;
    case Applied::refused:
      ++counts_.refused;
      return;
    case Applied::yes:
      ++counts_.applied;
  }
  echoes_.passed(arrival);
  const std::vector<Event> events = state_.takeEvents();
  if (options_.applied) options_.applied(*packet, events);
  noteThrough(packet->header.source, through);
  passOn(datagram, *packet, now);
}

void Relay::passOn(ByteView datagram, const Packet& packet, LogTime now) {
  const PacketHeader& header = packet.header;
  const bool is_judged = header.sequence && header.by.empty() && !header.reset;
  if (whole_ > 0 && is_judged) {
    outgoing_.push_back({kEveryWhole, datagram});
  } else if (whole_ > 0) {
    written_.push_back(withThrough(textOf(datagram), encoded_name_));
    send(kEveryWhole, written_);
  }
  if (whole_ == outputs_.size()) return;
  for (auto& [id, output] : outputs_) {
    if (output.filtered == nullptr) continue;
    output.filtered->applied(state_, through_, packet, now, written_);
    send(id, written_);
    if (header.reset) {
      const LogTime soon = std::max(now, output.restated + kLeastBetweenRestatements);
      output.next_restatement = std::min(output.next_restatement, soon);
    }
    due_ = std::min(due_, dueOf(output));
  }
}

bool Relay::isRestating(const Output& output) {
  return output.filtered != nullptr ? output.filtered->isRestating() : output.greeting.has_value();
}

void Relay::begin(OutputId id, Output& output, LogTime now) {
  output.is_waiting = false;
  output.restated = now;
  if (output.filtered != nullptr) output.next_restatement = now + options_.restate;
  std::string part_id = options_.run + '.' + std::to_string(++restatements_);
  if (output.filtered != nullptr) {
    output.filtered->restate(state_, through_, std::move(part_id));
    return;
  }
  Restating::Options how;
  how.text_bytes = output.header->roomInParts(
      state_, through_, part_id, FilteredOutput::kDatagramBytes - options_.signature_bytes);
  how.id = std::move(part_id);
  output.greeting.emplace(state_, std::move(how));
  if (output.greeting->left() > RestatingPace::kMaxWithParts) output.greeting->leaveOutParts();
  sendGreeting(id, output, now);
}

void Relay::beginRestatements(LogTime now) {
  std::size_t quick = 0, slow = 0;
  for (const auto& [id, output] : outputs_) {
    if (isRestating(output)) ++(output.is_slow ? slow : quick);
  }
  for (auto& [id, output] : outputs_) {
    if (isRestating(output) && !output.is_waiting) continue;
    if (now >= output.next_restatement && !state_.restatementOpen(now)) output.is_waiting = true;
    if (!output.is_waiting) continue;
    std::size_t& busy = output.is_slow ? slow : quick;
    if (busy >= (output.is_slow ? kSlowRestating : kRestating)) continue;
    if (!isRestating(output)) ++busy;
    begin(id, output, now);
  }
}

void Relay::sendGreeting(OutputId id, Output& output, LogTime now) {
  while (!output.greeting->ended()) {
    if (!output.pace.allows(now)) return;
    SentOrders by_name;  // a greeting names its joints
    std::vector<RelayDraft> drafts = output.greeting->next(state_, nullptr, by_name);
    for (const RelayDraft& draft : drafts) {
      written_.push_back(output.header->datagramOf(draft, state_, through_, true));
    }
    output.pace.sent(drafts.size());
    send(id, written_);
  }
  output.greeting.reset();
}

void Relay::advance(LogTime now) {
  if (now < due_) return;
  beginRestatements(now);
  for (auto& [id, output] : outputs_) {
    if (output.filtered != nullptr) {
      output.filtered->advance(state_, through_, now, written_);
      send(id, written_);
    } else if (output.greeting) {
      sendGreeting(id, output, now);
    }
  }
  due_ = dueOfAll();
  const bool any_waits = std::any_of(outputs_.begin(), outputs_.end(),
                                     [](const auto& each) { return each.second.is_waiting; });
  // An output may wait for its turn, or for the end of a source's restatement.
  if (any_waits || due_ <= now) due_ = now + kTurn;
}

LogTime Relay::dueOf(const Output& output) {
  LogTime due = output.next_restatement;
  if (output.filtered != nullptr) due = std::min(due, output.filtered->due());
  if (output.greeting) due = std::min(due, output.pace.allowsAt());
  return due;
}

LogTime Relay::dueOfAll() const {
  LogTime due = LogTime::max();
  for (const auto& each : outputs_) due = std::min(due, dueOf(each.second));
  return due;
}

}  // namespace rocinante
