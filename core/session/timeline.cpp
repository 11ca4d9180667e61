#include "core/session/timeline.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/log/log_profile.h"
#include "core/packet/decoder.h"
#include "core/session/marks.h"

namespace rocinante {
namespace {

constexpr LogTime kBeforeAll{Nanoseconds(std::numeric_limits<std::int64_t>::min())};
constexpr LogTime kAfterAll{Nanoseconds(std::numeric_limits<std::int64_t>::max())};

/// Folding this many messages takes a few milliseconds: nobody waits for it.
constexpr std::uint64_t kFirstInterval = 4096;
constexpr std::size_t kMostSnapshots = 512;
constexpr std::uint64_t kMostSnapshotBytes = std::uint64_t{64} << 20U;

}  // namespace

struct Timeline::Impl {
  explicit Impl(LogReader log_reader) : reader(std::move(log_reader)) {}

  LogReader reader;
  std::map<std::string, std::unique_ptr<Decoder>, std::less<>> decoders;
  std::vector<Decoder*> decoder_by_channel;  ///< null: not folded, or nobody can decode it

  SessionState state;
  LogTime folded_to = kBeforeAll;       ///< every message up to here is in `state`
  std::optional<LogMessage> lookahead;  ///< the first that is not, borrowed from the reader
  bool at_end = false;

  /// States kept on the way, each with all messages up to its time, so that going back starts near.
  std::map<LogTime, SessionState> snapshots;
  std::uint64_t snapshot_bytes = 0;
  std::uint64_t interval = kFirstInterval;  ///< messages between two
  std::uint64_t since_snapshot = 0;

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

  Status startFrom(LogTime moment, SessionState from) {
    state = std::move(from);
    folded_to = moment;
    lookahead.reset();
    at_end = false;
    since_snapshot = 0;
    return moment == kBeforeAll ? reader.rewind() : reader.seek(moment + Nanoseconds(1));
  }

  /// Begins at the nearest state known that is not later than `moment`.
  Status approach(LogTime moment) {
    const auto later = snapshots.upper_bound(moment);
    const auto nearest = later == snapshots.begin() ? snapshots.end() : std::prev(later);
    if (folded_to <= moment) {
      // Going on beats starting anew, unless a snapshot lies ahead.
      if (nearest == snapshots.end() || nearest->first <= folded_to) return {};
    }
    if (nearest == snapshots.end()) return startFrom(kBeforeAll, SessionState{});
    return startFrom(nearest->first, nearest->second);
  }

  /// Folds on up to and with `moment`. Events go to `sink`, if there is one.
  Status foldTo(LogTime moment, std::vector<Event>* sink) {
    while (!at_end) {
      if (!lookahead) {
        Result<std::optional<LogMessage>> message = reader.next();
        if (!message) return message.error();
        if (!*message) {
          at_end = true;
          break;
        }
        lookahead = **message;
      }
      if (lookahead->log_time > moment) break;
      if (lookahead->log_time > folded_to && since_snapshot >= interval) keepSnapshot();
      fold(*lookahead, sink);
      folded_to = lookahead->log_time;
      lookahead.reset();
    }
    folded_to = std::max(folded_to, moment);
    return {};
  }

  void fold(const LogMessage& message, std::vector<Event>* sink) {
    Decoder* const decoder = decoder_by_channel[message.channel->id];
    ++since_snapshot;
    if (sink != nullptr && message.channel->topic == profile::kMarkTopic) {
      if (auto mark = parseMark(message.payload)) sink->push_back({message.log_time, {}, *mark});
    }
    if (decoder == nullptr) return;
    const Packet* const packet = decoder->decode(message.payload);
    if (packet == nullptr) return;
    state.apply(message.log_time, *packet);
    // They would pile up otherwise, and be copied into every snapshot.
    std::vector<Event> told = state.takeEvents();
    if (sink != nullptr) sink->insert(sink->end(), told.begin(), told.end());
  }

  void keepSnapshot() {
    since_snapshot = 0;
    if (!snapshots.emplace(folded_to, state).second) return;
    snapshot_bytes += state.weight();
    if (snapshots.size() <= kMostSnapshots && snapshot_bytes <= kMostSnapshotBytes) return;
    // Every second one goes: still evenly spread, at twice the distance.
    interval *= 2;
    bool drop = true;
    for (auto it = snapshots.begin(); it != snapshots.end(); drop = !drop) {
      if (!drop) {
        ++it;
        continue;
      }
      snapshot_bytes -= it->second.weight();
      it = snapshots.erase(it);
    }
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

Result<const SessionState*> Timeline::stateAt(LogTime moment) {
  if (Status near = impl_->approach(moment); !near) return near.error();
  if (Status folded = impl_->foldTo(moment, nullptr); !folded) return folded.error();
  return &impl_->state;
}

Result<const std::vector<Event>*> Timeline::events() {
  if (!impl_->events) {
    std::vector<Event> found;
    if (Status begun = impl_->startFrom(kBeforeAll, SessionState{}); !begun) return begun.error();
    if (Status folded = impl_->foldTo(kAfterAll, &found); !folded) return folded.error();
    // Marks stand in order of time too; of equal ones, what the log tells comes first.
    Result<std::vector<Event>> marks = readMarks(impl_->reader.name());
    if (!marks) return marks.error();
    const auto beside = found.insert(found.end(), marks->begin(), marks->end());
    std::inplace_merge(found.begin(), beside, found.end(),
                       [](const Event& a, const Event& b) { return a.time < b.time; });
    impl_->events = std::move(found);
  }
  return &*impl_->events;
}

const LogReader& Timeline::log() const { return impl_->reader; }

}  // namespace rocinante
