#include "core/session/timeline.h"

#include <algorithm>
#include <utility>

#include "core/session/log_fold.h"
#include "core/session/log_pieces.h"
#include "core/session/marks.h"

namespace rocinante {
namespace {

/// Only the pieces used last hold states.
constexpr std::size_t kPiecesWithStates = 2;

bool isBefore(const Event& a, const Event& b) { return a.time < b.time; }

}  // namespace

struct Timeline::Impl {
  /// In time order, at least one; only the last may grow.
  std::vector<std::unique_ptr<LogFold>> pieces;
  std::vector<const LogFold*> used;     ///< the last ones, the latest behind
  std::optional<NextPiece> next_piece;  ///< looks for it; empty: not followed
  std::vector<Event> events;
  bool events_found = false;
  std::stop_token stop;

  LogFold& last() { return *pieces.back(); }

  /// The piece that has the moment: the last that does not begin after it.
  LogFold& pieceAt(LogTime moment) {
    auto piece = pieces.rbegin();
    while (std::next(piece) != pieces.rend() && (*piece)->reader().summary().start > moment) {
      ++piece;
    }
    use(**piece);
    return **piece;
  }

  void use(const LogFold& piece) {
    std::erase(used, &piece);
    used.push_back(&piece);
    if (used.size() <= kPiecesWithStates) return;
    for (const auto& each : pieces) {
      if (each.get() == used.front()) each->releaseStates();
    }
    used.erase(used.begin());
  }

  Result<bool> refresh() {
    if (!next_piece) return false;
    Result<bool> changed = last().refresh();
    if (!changed) return changed;
    if (!last().reader().growing()) {
      Result<std::optional<LogReader>> next = next_piece->after(last().reader());
      if (!next) return next.error();
      if (*next) {
        pieces.push_back(std::make_unique<LogFold>(*std::move(*next)));
        last().useStop(stop);
        changed = true;
      }
    }
    if (dropDeleted()) changed = true;
    return changed;
  }

  /// Pieces that their writer has deleted are no longer part of the session.
  bool dropDeleted() {
    std::error_code ignored;
    std::size_t gone = 0;
    while (gone + 1 < pieces.size() &&
           !std::filesystem::exists(pieces[gone]->reader().name(), ignored)) {
      std::erase(used, pieces[gone].get());
      ++gone;
    }
    pieces.erase(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(gone));
    return gone > 0;
  }

  Status findEvents(const TellLoadProgress& progress) {
    events.clear();
    LoadProgress now;
    now.files_total = pieces.size();
    for (const auto& piece : pieces) now.bytes_total += piece->reader().storage().file_bytes;
    for (const auto& piece : pieces) {
      const std::uint64_t bytes = piece->reader().storage().file_bytes;
      const auto tell = [&](double part) {
        LoadProgress within = now;
        within.bytes_done += static_cast<std::uint64_t>(part * static_cast<double>(bytes));
        progress(within);
      };
      Result<const std::vector<Event>*> found =
          piece->events(progress ? tell : std::function<void(double)>());
      if (!found) return found.error();
      ++now.files_done;
      now.bytes_done += bytes;
      events.insert(events.end(), (*found)->begin(), (*found)->end());
    }
    if (progress) progress(now);
    // Marks are in time order too; at equal times, events from the log come first.
    for (const auto& piece : pieces) {
      Result<std::vector<Event>> marks = readMarks(piece->reader().name());
      if (!marks) return marks.error();
      const auto beside = events.insert(events.end(), marks->begin(), marks->end());
      std::inplace_merge(events.begin(), beside, events.end(), isBefore);
    }
    events_found = true;
    return {};
  }
};

Result<Timeline> Timeline::open(const std::filesystem::path& path) {
  Result<LogReader> reader = LogReader::open(path);
  if (!reader) return reader.error();
  return of(std::move(*reader));
}

Result<Timeline> Timeline::follow(const std::filesystem::path& path) {
  Result<LogReader> reader = LogReader::openGrowing(path);
  if (!reader) return reader.error();
  Timeline line = of(std::move(*reader));
  line.impl_->next_piece.emplace();
  // The pieces that follow already.
  for (std::size_t known = 0; known < line.impl_->pieces.size();) {
    known = line.impl_->pieces.size();
    if (const Result<bool> more = line.refresh(); !more) return more.error();
  }
  return line;
}

Timeline Timeline::of(LogReader reader) {
  auto impl = std::make_unique<Impl>();
  impl->pieces.push_back(std::make_unique<LogFold>(std::move(reader)));
  return Timeline(std::move(impl));
}

Timeline::Timeline(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Timeline::~Timeline() = default;
Timeline::Timeline(Timeline&&) noexcept = default;
Timeline& Timeline::operator=(Timeline&&) noexcept = default;

void Timeline::useStop(std::stop_token stop) {
  for (const auto& piece : impl_->pieces) piece->useStop(stop);
  impl_->stop = std::move(stop);
}

LogTime Timeline::origin() const { return impl_->pieces.front()->reader().summary().origin; }
LogTime Timeline::start() const { return impl_->pieces.front()->reader().summary().start; }
LogTime Timeline::end() const { return impl_->last().reader().summary().end; }

Result<bool> Timeline::refresh() {
  Result<bool> changed = impl_->refresh();
  if (changed && *changed) impl_->events_found = false;
  return changed;
}

bool Timeline::growing() const {
  const LogReader& last = impl_->last().reader();
  return impl_->next_piece && (last.growing() || NextPiece::expected(last));
}

Result<const SessionState*> Timeline::stateAt(LogTime moment, StateDamage* damage) {
  return impl_->pieceAt(moment).stateUpTo(lastAt(moment), damage);
}

Result<const SessionState*> Timeline::stateBefore(LogPosition place, StateDamage* damage) {
  return impl_->pieceAt(place.time).stateUpTo(lastBefore(place), damage);
}

Status Timeline::addDamage(LogTime from, LogTime until, StateDamage& damage) {
  Impl& line = *impl_;
  const LogFold* const first = &line.pieceAt(from);
  bool within = false;
  for (const auto& piece : line.pieces) {
    within = within || piece.get() == first;
    if (!within) continue;
    const LogTime start = piece->reader().summary().start;
    if (piece.get() != first && start > until) break;
    line.use(*piece);
    const LogTime begin = piece.get() == first ? from : start;
    if (Status added = piece->addDamage(begin, until, damage); !added) return added;
  }
  return {};
}

const std::vector<KeyframeFault>& Timeline::keyframeFaults() const {
  return impl_->last().keyframeFaults();
}

Result<const std::vector<Event>*> Timeline::events(StateDamage* damage,
                                                   const TellLoadProgress& progress) {
  Impl& line = *impl_;
  if (!line.events_found) {
    if (Status found = line.findEvents(progress); !found) return found.error();
  }
  StateDamage hiding;
  for (const auto& piece : line.pieces) piece->addHidingDamage(hiding);
  if (hiding.empty()) return &line.events;
  if (damage == nullptr) {
    return Error{ErrorKind::damaged, "an event may be missing: " + hiding.what(), hiding.where()};
  }
  damage->add(hiding);
  return &line.events;
}

const LogReader& Timeline::log() const { return impl_->last().reader(); }

const LogReader& Timeline::logAt(LogTime moment) const { return impl_->pieceAt(moment).reader(); }

}  // namespace rocinante
