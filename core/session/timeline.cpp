#include "core/session/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "core/base/duration_text.h"
#include "core/log/log_profile.h"
#include "core/packet/decoder.h"
#include "core/session/keyframe_finder.h"
#include "core/session/marks.h"
#include "core/session/state_cache.h"

namespace rocinante {
namespace {

constexpr LogPosition kStartOfLog{LogTime::min(), 0};

/// Folding this many messages is quicker than searching for a start.
constexpr std::uint64_t kNearMessages = 1024;
constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();

/// The position behind every message of the moment.
LogPosition endOf(LogTime moment) { return {moment, std::numeric_limits<std::uint64_t>::max()}; }

}  // namespace

struct Timeline::Impl {
  explicit Impl(LogReader log_reader) : reader(std::move(log_reader)), finder(reader) {}

  LogReader reader;
  KeyframeFinder finder;
  std::map<std::string, std::unique_ptr<Decoder>, std::less<>> decoders;
  std::vector<Decoder*> decoder_by_channel;  ///< null: not folded, or without a decoder

  // The state of the last usable keyframe before `reached`, or the empty one, plus all messages
  // behind that up to `reached`. Holds for any way of reaching it, even when the log contradicts
  // itself.
  SessionState state;
  LogPosition reached = kStartOfLog;
  LogPosition base = kStartOfLog;       ///< of that keyframe
  std::uint64_t since_base = 0;         ///< messages read since then
  std::uint64_t since_kept = 0;         ///< since a state was kept
  std::optional<LogMessage> lookahead;  ///< the first behind `reached`, borrowed from the reader
  bool at_end = false;
  bool placed = false;  ///< the reader's next message is the first behind `reached`

  StateCache cache;
  std::optional<std::vector<Event>> events;

  void chooseDecoders() {
    for (const LogChannel& channel : reader.channels()) {
      if (decoder_by_channel.size() <= channel.id) decoder_by_channel.resize(channel.id + 1U);
      if (!channel.folded()) continue;
      auto found = decoders.find(channel.encoding);
      if (found == decoders.end()) {
        found = decoders.emplace(channel.encoding, makeDecoder(channel.encoding)).first;
      }
      decoder_by_channel[channel.id] = found->second.get();
    }
  }

  void startFrom(LogPosition place, SessionState from, LogPosition its_base,
                 std::uint64_t messages) {
    state = std::move(from);
    reached = place;
    base = its_base;
    since_base = messages;
    since_kept = 0;
    goBehindReached();
  }

  /// The reader is moved there when it is next used.
  void goBehindReached() {
    lookahead.reset();
    at_end = false;
    placed = false;
  }

  /// Starts from the nearest known position that is not later than `moment`.
  Status approach(LogTime moment) {
    const bool can_go_on = reached <= endOf(moment);
    const auto* kept = cache.nearest(endOf(moment));
    std::optional<LogPosition> known;
    if (can_go_on && reached != kStartOfLog) known = reached;
    if (kept != nullptr && (!known || kept->first > *known)) known = kept->first;
    Result<std::optional<KeyframeFinder::Found>> found = finder.lastBefore(moment, known);
    if (!found) return found.error();
    // The message borrowed from the reader is no longer valid.
    goBehindReached();
    if (*found) {
      cache.keep((*found)->place, (*found)->state, (*found)->place, 0);
      startFrom((*found)->place, std::move((*found)->state), (*found)->place, 0);
    } else if (kept != nullptr && !(can_go_on && reached >= kept->first)) {
      startFrom(kept->first, kept->second.state, kept->second.base, kept->second.messages);
    } else if (!can_go_on) {
      startFrom(kStartOfLog, SessionState{}, kStartOfLog, 0);
    }
    return {};
  }

  Status reach(LogTime moment) {
    if (reached <= endOf(moment) && reached != kStartOfLog) {
      const Result<bool> near = foldTo(moment, kNearMessages, nullptr);
      if (!near) return near.error();
      if (*near) return {};
    }
    if (Status begun = approach(moment); !begun) return begun;
    if (Result<bool> folded = foldTo(moment, kAll, nullptr); !folded) return folded.error();
    return {};
  }

  /// Folds up to and including `moment`, at most `most` messages: false when that was not enough.
  /// Events go to `sink`, if there is one.
  Result<bool> foldTo(LogTime moment, std::uint64_t most, std::vector<Event>* sink) {
    if (!placed) {
      const Status put = reached == kStartOfLog ? reader.rewind() : reader.seekAfter(reached);
      if (!put) return put.error();
      placed = true;
    }
    for (std::uint64_t count = 0;; ++count) {
      if (!lookahead && !at_end) {
        Result<std::optional<LogMessage>> message = reader.next();
        if (!message) return message.error();
        if (*message) lookahead = **message;
        at_end = !*message;
      }
      if (at_end || lookahead->log_time > moment) return true;
      if (count == most) return false;
      fold(*lookahead, sink);
      lookahead.reset();
    }
  }

  void fold(const LogMessage& message, std::vector<Event>* sink) {
    reached = message.place();
    ++since_base;
    ++since_kept;
    if (finder.isOne(message)) {
      adopt(message);
    } else if (Decoder* const decoder = decoder_by_channel[message.channel->id]) {
      if (const Packet* const packet = decoder->decode(message.payload)) {
        state.apply(message.log_time, *packet);
        // Otherwise they would accumulate, and be copied into every kept state.
        std::vector<Event> told = state.takeEvents();
        if (sink != nullptr) sink->insert(sink->end(), told.begin(), told.end());
      }
    } else if (sink != nullptr && message.channel->topic == profile::kMarkTopic) {
      if (auto mark = parseMark(message.payload)) sink->push_back({message.log_time, {}, *mark});
    }
    if (since_kept >= StateCache::interval(state)) keepState();
  }

  void adopt(const LogMessage& message) {
    std::optional<SessionState> told = finder.usable(message);
    if (!told) return;
    state = std::move(*told);
    base = reached;
    since_base = 0;
    keepState();
  }

  void keepState() {
    since_kept = 0;
    cache.keep(reached, state, base, since_base);
  }
};

Result<Timeline> Timeline::open(const std::filesystem::path& path) {
  Result<LogReader> reader = LogReader::open(path);
  if (!reader) return reader.error();
  return of(std::move(*reader));
}

Timeline Timeline::of(LogReader reader) {
  auto impl = std::make_unique<Impl>(std::move(reader));
  impl->chooseDecoders();
  return Timeline(std::move(impl));
}

Timeline::Timeline(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Timeline::~Timeline() = default;
Timeline::Timeline(Timeline&&) noexcept = default;
Timeline& Timeline::operator=(Timeline&&) noexcept = default;

LogTime Timeline::origin() const { return impl_->reader.summary().origin; }
LogTime Timeline::start() const { return impl_->reader.summary().start; }
LogTime Timeline::end() const { return impl_->reader.summary().end; }

Result<const SessionState*> Timeline::stateAt(LogTime moment, StateDamage* damage) {
  Impl& line = *impl_;
  if (Status reached = line.reach(moment); !reached) return reached.error();
  if (line.reader.unreadable().empty()) return &line.state;
  StateDamage found;
  addDamageBetween(line.reader, line.base, moment, found);
  if (found.empty()) return &line.state;
  if (damage == nullptr) {
    return Error{ErrorKind::damaged,
                 fmt::format("the state at {} s is not known: {}",
                             secondsText(moment - origin(), 3), found.what()),
                 found.where()};
  }
  damage->add(found);
  return &line.state;
}

Status Timeline::addDamage(LogTime from, LogTime until, StateDamage& damage) {
  if (Result<const SessionState*> begun = stateAt(from, &damage); !begun) return begun.error();
  Impl& line = *impl_;
  const LogPosition base = line.base;
  line.goBehindReached();
  if (Status put = line.reader.seek(from); !put) return put.error();
  while (true) {
    const Result<std::optional<LogMessage>> message = line.reader.next();
    if (!message) return message.error();
    if (!*message || (*message)->log_time > until) break;
  }
  addDamageBetween(line.reader, base, until, damage);
  return {};
}

const std::vector<KeyframeFault>& Timeline::keyframeFaults() const {
  return impl_->finder.faults();
}

Result<const std::vector<Event>*> Timeline::events(StateDamage* damage) {
  Impl& line = *impl_;
  if (!line.events) {
    std::vector<Event> found;
    line.startFrom(kStartOfLog, SessionState{}, kStartOfLog, 0);
    if (Result<bool> folded = line.foldTo(LogTime::max(), kAll, &found); !folded) {
      return folded.error();
    }
    // Marks are in time order too; at equal times, events from the log come first.
    Result<std::vector<Event>> marks = readMarks(line.reader.name());
    if (!marks) return marks.error();
    const auto beside = found.insert(found.end(), marks->begin(), marks->end());
    std::inplace_merge(found.begin(), beside, found.end(),
                       [](const Event& a, const Event& b) { return a.time < b.time; });
    line.events = std::move(found);
  }
  if (line.reader.unreadable().empty()) return &*line.events;
  StateDamage hiding;
  addDamageBetween(line.reader, kStartOfLog, end(), hiding);
  if (hiding.empty()) return &*line.events;
  if (damage == nullptr) {
    return Error{ErrorKind::damaged, "an event may be missing: " + hiding.what(), hiding.where()};
  }
  damage->add(hiding);
  return &*line.events;
}

const LogReader& Timeline::log() const { return impl_->reader; }

}  // namespace rocinante
