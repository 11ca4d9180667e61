#include "player/logs/tape_finder.h"

#include <algorithm>
#include <iterator>

namespace rocinante {
namespace {

/// For 8 million messages they are at most 16,384 messages apart: some milliseconds to fold.
constexpr std::size_t kMaxKept = 1024;
/// Memory limit of the kept states, as they report it; one that is too large is not kept.
constexpr std::uint64_t kMaxKeptBytes = std::uint64_t{64} << 20U;
constexpr std::uint64_t kHeaviest = kMaxKeptBytes / 16;

Status addEventTimes(Timeline& timeline, std::vector<LogTime>& times) {
  const Result<const std::vector<Event>*> events = timeline.events();
  if (!events) return events.error();
  for (const Event& event : **events) times.push_back(event.time);
  return {};
}

std::uint64_t bytesOfKept(const SessionState& state) { return sizeof(state) + state.weight(); }

}  // namespace

Result<TapeFinder> TapeFinder::open(std::vector<std::filesystem::path> paths,
                                    ChannelChoice choice) {
  Result<MultiLogReader> merge = MultiLogReader::open(paths, choice);
  if (!merge) return merge.error();
  TapeFinder finder(std::move(paths), std::move(choice), std::move(*merge));
  finder.sources_ = finder.merge_.sources();
  if (finder.paths_.size() == 1 && finder.choice_.isAll()) {
    Result<Timeline> timeline = Timeline::open(finder.paths_[0]);
    if (!timeline) return timeline.error();
    finder.timeline_ = std::move(*timeline);
  }
  return finder;
}

void TapeFinder::keep(TapePosition place, const SessionState& state) {
  if (bytesOfKept(state) > kHeaviest || !kept_.try_emplace(place, state).second) return;
  kept_bytes_ += bytesOfKept(state);
  if (kept_.size() < kMaxKept && kept_bytes_ < kMaxKeptBytes) return;
  for (auto each = kept_.begin(); each != kept_.end();) {
    kept_bytes_ -= bytesOfKept(each->second);
    each = kept_.erase(each);
    if (each != kept_.end()) ++each;
  }
  keep_each_ *= 2;
}

Result<SessionState> TapeFinder::stateBefore(TapePosition place) {
  Result<SessionState> state = SessionState();
  if (timeline_) {
    const auto found = timeline_->stateBefore({place.time, place.file_offset}, &state_damage_);
    if (!found) return found.error();
    state = **found;
  } else {
    state = foldUpTo(place);
    if (!state) return state;
  }
  for (const auto& [source, memory] : state->sources()) sources_.insert(source);
  return state;
}

Result<SessionState> TapeFinder::foldUpTo(TapePosition place) {
  TapePosition from = TapePosition::at(LogTime::min());
  SessionState state;
  if (const auto after = kept_.upper_bound(place); after != kept_.begin()) {
    from = std::prev(after)->first;
    state = std::prev(after)->second;
  }
  if (const Status put = merge_.seek(from, MultiLogReader::Which::received); !put)
    return put.error();
  for (std::uint64_t count = 1;; ++count) {
    const Result<std::optional<LogMessage>> message = merge_.next();
    if (!message) return message.error();
    if (!*message || merge_.place() >= place) break;
    folder_.fold(state, **message);
    if (count % keep_each_ == 0) keep(TapePosition::behind(merge_.place()), state);
  }
  return state;
}

Result<bool> TapeFinder::anyIn(LogTime from, LogTime until) {
  if (const Status put = merge_.seek(TapePosition::at(from), MultiLogReader::Which::captured);
      !put) {
    return put.error();
  }
  const Result<std::optional<LogMessage>> first = merge_.next();
  if (!first) return first.error();
  return *first && (*first)->log_time < until;
}

Result<MultiLogReader::Earlier> TapeFinder::back(TapePosition place, std::uint64_t count,
                                                 LogTime floor) {
  return merge_.back(place, count, floor);
}

Result<const std::vector<LogTime>*> TapeFinder::eventTimes() {
  if (!event_times_) {
    std::vector<LogTime> times;
    if (timeline_) {
      if (Status added = addEventTimes(*timeline_, times); !added) return added.error();
    } else {
      for (const auto& path : paths_) {
        Result<Timeline> timeline = Timeline::open(path);
        if (!timeline) return timeline.error();
        if (Status added = addEventTimes(*timeline, times); !added) return added.error();
      }
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    event_times_ = std::move(times);
  }
  return &*event_times_;
}

}  // namespace rocinante
