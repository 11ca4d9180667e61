#include "viewer/ui/study/log_study.h"

#include <algorithm>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/thread_priority.h"
#include "core/log/log_reader.h"
#include "core/series/positional_names.h"
#include "core/session/timeline.h"
#include "viewer/ui/study/log_scan.h"
#include "viewer/ui/study/plotted_table.h"
#include "viewer/ui/study/source_strips.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMaxColumns = 8192;
/// How often pictures show what has been read so far.
constexpr Nanoseconds kShowEvery = 100ms;
/// How often a growing log is looked at.
constexpr Nanoseconds kLookEvery = 150ms;

}  // namespace

struct LogStudy::Impl {
  Impl(const Cell& the_cell, std::filesystem::path path, bool grows)
      : cell(the_cell), names(positionalNames(the_cell)), log(std::move(path)), follows(grows) {}

  void work(const std::stop_token& stop);
  SeriesScan::Options optionsFor(LogTime from, LogTime until,
                                 std::optional<std::set<SeriesKey>> only) const;
  Status begin(const std::stop_token& stop);
  Status read(LogScan& scan, const std::function<bool()>& goes_on);
  Status readAll(const std::stop_token& stop);
  Status readChosen(const StudyQuery& wish, const std::stop_token& stop);
  Result<bool> readMore(const std::stop_token& stop);
  Status answer(const StudyQuery& wish, const std::stop_token& stop);
  Status refine(const StudyQuery& wish, const std::stop_token& stop);
  bool isFineEnough(const StudyQuery& wish) const;
  const LogScan* scanOf(const SeriesKey& key) const;
  void publish(const StudyQuery& wish, const LogScan* refined, bool whole);
  LogTime reachedBy(const LogScan& scan) const;
  Result<std::string> tableOf(const TableQuery& wish, const std::stop_token& stop);
  Result<SessionState> stateAt(LogTime moment);
  StudyQuery wished() {
    const std::lock_guard lock(mutex);
    return newest;
  }

  // Only the worker thread touches these.
  const Cell& cell;
  PositionalNames names;
  std::filesystem::path log;
  bool follows;
  std::optional<Timeline> timeline;
  LogTime start{}, end{};
  std::unique_ptr<LogScan> all, part;
  std::unique_ptr<LogScan> chosen;  ///< of what is gathered only when asked for
  std::set<SeriesKey> chosen_keys;  ///< its values; empty: it is not whole
  SteadyTime looked{};              ///< whether the log has grown
  std::set<SeriesKey> part_keys;
  std::shared_ptr<const std::vector<SeriesKey>> stated;  ///< null: not all is read
  std::shared_ptr<const std::set<SeriesKey>> texts;      ///< of them

  std::mutex mutex;
  std::condition_variable_any asked, answered;
  // Guarded by mutex.
  StudyQuery newest;
  std::uint64_t wishes = 0;         ///< number of the newest
  std::uint64_t whole_answers = 0;  ///< number of the newest answered wholly
  std::shared_ptr<const StudyPicture> picture;
  bool news = false;
  std::optional<TableQuery> table_wish;
  bool table_busy = false;
  std::optional<Result<std::string>> made_table;
  std::string fault;

  std::jthread thread;  // last: it ends first
};

LogStudy::LogStudy(const Cell& cell, std::filesystem::path log, bool grows)
    : impl_(std::make_unique<Impl>(cell, std::move(log), grows)) {
  Impl& impl = *impl_;
  impl.thread = std::jthread([&impl](const std::stop_token& stop) { impl.work(stop); });
}

LogStudy::~LogStudy() = default;

SeriesScan::Options LogStudy::Impl::optionsFor(LogTime from, LogTime until,
                                               std::optional<std::set<SeriesKey>> only) const {
  SeriesScan::Options options;
  options.from = from;
  options.until = until;
  options.names = names;
  options.cell = &cell;
  options.only = std::move(only);
  return options;
}

Status LogStudy::Impl::begin(const std::stop_token& stop) {
  auto reader = follows ? LogReader::openGrowing(log) : LogReader::open(log);
  if (!reader.ok()) return reader.error();
  auto second = follows ? LogReader::openGrowing(log) : LogReader::open(log);
  if (!second.ok()) return second.error();
  timeline = Timeline::of(std::move(*second));
  timeline->useStop(stop);
  start = timeline->start();
  end = timeline->end();
  if (Status there = reader->rewind(); !there) return there;
  all = std::make_unique<LogScan>(std::move(*reader), optionsFor(start, end, std::nullopt), start,
                                  LogTime::max(), follows);
  return {};
}

/// Reads to the end, and shows what is known meanwhile.
Status LogStudy::Impl::read(LogScan& scan, const std::function<bool()>& goes_on) {
  SteadyTime shown = std::chrono::steady_clock::now();
  StudyQuery last;
  while (!scan.ended() && goes_on()) {
    if (Status read = scan.step(); !read) return read;
    const StudyQuery wanted = wished();
    if (wanted.strip_columns == 0 && wanted.columns == 0) continue;
    if (wanted == last && std::chrono::steady_clock::now() - shown < kShowEvery) continue;
    publish(wanted, nullptr, false);
    last = wanted;
    shown = std::chrono::steady_clock::now();
  }
  return {};
}

Status LogStudy::Impl::readAll(const std::stop_token& stop) {
  if (Status done = read(*all, [&stop] { return !stop.stop_requested(); }); !done) return done;
  all->addLosses();
  end = std::max(end, all->series().reached());
  return {};
}

/// What packets do not state themselves is gathered by another pass, for all that is wished of it.
Status LogStudy::Impl::readChosen(const StudyQuery& wish, const std::stop_token& stop) {
  std::set<SeriesKey> keys = chosenKeys(wish);
  if (std::ranges::includes(chosen_keys, keys)) return {};
  const bool grows = !all->isComplete();
  auto reader = grows ? LogReader::openGrowing(log) : LogReader::open(log);
  if (!reader.ok()) return reader.error();
  if (Status there = reader->rewind(); !there) return there;
  chosen_keys.clear();
  chosen = std::make_unique<LogScan>(std::move(*reader), optionsFor(start, end, keys), start,
                                     LogTime::max(), grows);
  const auto goes_on = [&] {
    return !stop.stop_requested() && std::ranges::includes(keys, chosenKeys(wished()));
  };
  if (Status done = read(*chosen, goes_on); !done) return done;
  if (chosen->ended()) chosen_keys = std::move(keys);
  return {};
}

/// What was appended since; true when there was something.
Result<bool> LogStudy::Impl::readMore(const std::stop_token& stop) {
  if (!all->grows() || std::chrono::steady_clock::now() - looked < kLookEvery) return false;
  looked = std::chrono::steady_clock::now();
  bool any = false;
  while (!stop.stop_requested()) {
    const auto more = all->more();
    if (!more.ok() || !*more) return more.ok() ? Result<bool>(any) : more;
    any = true;
    if (Status read = readAll(stop); !read) return read.error();
  }
  const auto goes_on = [&stop] { return !stop.stop_requested(); };
  while (chosen != nullptr && any && goes_on()) {
    const auto more = chosen->more();
    if (!more.ok() || !*more) return more.ok() ? Result<bool>(any) : more;
    if (Status done = read(*chosen, goes_on); !done) return done.error();
  }
  return any;
}

/// The state of everything up to `moment`, as far as a damaged log has it.
Result<SessionState> LogStudy::Impl::stateAt(LogTime moment) {
  if (follows) {
    // Opened before it had all that it has now.
    auto complete = Timeline::open(log);
    if (!complete.ok()) return complete.error();
    timeline = std::move(*complete);
    follows = false;
  }
  StateDamage ignored;  // pictures show where it is
  const auto state = timeline->stateAt(moment, &ignored);
  if (!state.ok()) return state.error();
  return **state;
}

/// A bin that is known is no wider than a pixel.
bool LogStudy::Impl::isFineEnough(const StudyQuery& wish) const {
  return std::ranges::all_of(wish.values(), [&](const SeriesKey& key) {
    const LogScan* const scan = key.isValue() ? scanOf(key) : nullptr;
    return scan == nullptr || scan->isFine(key, wish.pixel());
  });
}

/// Reads the part that is shown once more, and a little on both sides, until another wish comes.
Status LogStudy::Impl::refine(const StudyQuery& wish, const std::stop_token& stop) {
  const Nanoseconds span = wish.until - wish.from;
  const Nanoseconds pixel = wish.pixel();
  std::set<SeriesKey> keys = wish.values();
  const bool known = part && part->ended() && part->from() <= wish.from &&
                     part->until() >= wish.until &&
                     (part->until() - part->from()) / 16384 <= pixel && part_keys == keys;
  if (!known) {
    part.reset();
    const Nanoseconds beside = span / 2;
    const LogTime from = std::max(start, wish.from - std::min(beside, wish.from - start));
    const LogTime until = wish.until + std::min(beside, std::max(Nanoseconds(0), end - wish.until));
    // What is derived begins with what lies before.
    const LogTime first = from - std::min(reachOf(keys), from - start);
    // At the log's start even the first sample has its time, which `before` does not know.
    const bool begins = first == start;
    auto before = begins ? SessionState() : stateAt(first);
    if (!before.ok()) return before.error();
    auto reader = LogReader::open(log);
    if (!reader.ok()) return reader.error();
    const Status there = begins ? reader->rewind() : reader->seek(first + Nanoseconds(1));
    if (!there) return there;
    auto scan =
        std::make_unique<LogScan>(std::move(*reader), optionsFor(from, until, keys), from, until);
    if (!begins) scan->series().beginWith(std::move(*before), first);
    while (!scan->ended()) {
      if (Status read = scan->step(); !read) return read;
      if (stop.stop_requested() || !(wished() == wish)) return {};
    }
    part = std::move(scan);
    part_keys = std::move(keys);
  }
  publish(wish, part.get(), true);
  return {};
}

/// The pass that gathers a value; null: it has not begun.
const LogScan* LogStudy::Impl::scanOf(const SeriesKey& key) const {
  return isChosen(key) ? chosen.get() : all.get();
}

/// Until when a pass knows its values.
LogTime LogStudy::Impl::reachedBy(const LogScan& scan) const {
  if (!scan.ended()) return scan.series().reached();
  return all->ended() && !all->grows() ? LogTime::max() : end;
}

/// `refined`: has the values of the shown part; null: those that are known of all.
void LogStudy::Impl::publish(const StudyQuery& wish, const LogScan* refined, bool whole) {
  auto made = std::make_shared<StudyPicture>();
  made->wish = wish;
  made->reached = all->ended() ? end : all->series().reached();
  made->whole = whole;
  made->strips = stripsOf(all->series(), wish, {start, end}, made->reached);
  for (const SeriesKey& key : wish.keys) {
    std::vector<ValueColumn>& columns = made->curves.emplace_back();
    StateCurve& states = made->states.emplace_back();
    const LogScan* const scan = refined != nullptr ? refined : scanOf(key);
    if (!key.isValue()) {
      columns = rateColumns(key, all->series(), wish, made->reached);
    } else if (scan != nullptr) {
      columns = columnsUntil(scan->series().values(key), wish, reachedBy(*scan));
      states = statesUntil(scan->series().states(key), wish, reachedBy(*scan));
    }
  }
  const LogScan& shown = refined != nullptr ? *refined : *all;
  made->units = unitsUntil(wish, all->series(), shown.series(), reachedBy(shown));
  StudyQuery finer = wish;
  finer.columns = StudyQuery::kPathColumns;
  const auto finely = [&](const SeriesKey& key) {
    const LogScan* const scan = refined != nullptr ? refined : scanOf(key);
    if (scan == nullptr) return std::vector<ValueColumn>();
    return columnsUntil(scan->series().values(key), finer, reachedBy(*scan));
  };
  for (const auto& [x, y] : wish.paths) made->paths.push_back({finely(x), finely(y)});
  made->damaged = all->damaged();
  if (!stated && all->ended() && !all->grows()) {
    stated = std::make_shared<std::vector<SeriesKey>>(all->series().keys());
    texts = std::make_shared<std::set<SeriesKey>>(textsOf(all->series()));
  }
  made->stated = stated;
  made->texts = texts;
  const std::lock_guard lock(mutex);
  made->fault = fault;
  picture = std::move(made);
  news = true;
}

Result<std::string> LogStudy::Impl::tableOf(const TableQuery& wish, const std::stop_token& stop) {
  const auto state_at = [this](LogTime moment) { return stateAt(moment); };
  const auto goes_on = [&stop] { return !stop.stop_requested(); };
  return writePlottedTable(wish, {cell, names, log, start, all->series(), state_at, goes_on});
}

/// A log that grows is known as finely as it was gathered.
Status LogStudy::Impl::answer(const StudyQuery& wish, const std::stop_token& stop) {
  if (Status done = readChosen(wish, stop); !done) return done;
  const bool fine = !all->isComplete() || isFineEnough(wish);
  publish(wish, nullptr, fine);
  return fine ? Status() : refine(wish, stop);
}

void LogStudy::Impl::work(const std::stop_token& stop) {
  lowerPriority();
  Status read = begin(stop);
  if (read) read = readAll(stop);
  const auto fail = [this](const Error& error) {
    const std::lock_guard lock(mutex);
    fault = error.text();
    auto shown =
        picture ? std::make_shared<StudyPicture>(*picture) : std::make_shared<StudyPicture>();
    shown->fault = fault;
    shown->whole = true;
    picture = std::move(shown);
    news = true;
  };
  if (!read) fail(read.error());
  while (!stop.stop_requested()) {
    StudyQuery wanted;
    std::uint64_t number = 0;
    std::optional<TableQuery> next_table;
    bool is_asked = false;
    {
      std::unique_lock lock(mutex);
      const auto wanting = [&] { return wishes > whole_answers || table_wish; };
      if (read && all->grows()) {
        is_asked = asked.wait_for(lock, stop, kLookEvery, wanting);
      } else {
        is_asked = asked.wait(lock, stop, wanting);
      }
      if (stop.stop_requested()) return;
      wanted = newest;
      number = wishes;
      next_table = std::exchange(table_wish, std::nullopt);
      table_busy = next_table.has_value();
    }
    if (read) {
      const auto more = readMore(stop);
      if (!more.ok()) fail(more.error());
      if (number > 0 && (is_asked || (more.ok() && *more))) {
        if (Status answered_it = answer(wanted, stop); !answered_it) fail(answered_it.error());
      }
    }
    std::optional<Result<std::string>> made;
    if (next_table) made = read ? tableOf(*next_table, stop) : Result<std::string>(read.error());
    const std::lock_guard lock(mutex);
    if (newest == wanted) whole_answers = number;
    if (made) made_table = std::move(made);
    table_busy = false;
    answered.notify_all();
  }
}

std::shared_ptr<const StudyPicture> LogStudy::show(const StudyQuery& wish) {
  Impl& impl = *impl_;
  std::unique_lock lock(impl.mutex);
  StudyQuery bounded = wish;
  bounded.columns = std::min(wish.columns, kMaxColumns);
  bounded.strip_columns = std::min(wish.strip_columns, kMaxColumns);
  if (!(bounded == impl.newest) || impl.wishes == 0) {
    impl.newest = std::move(bounded);
    ++impl.wishes;
    impl.asked.notify_all();
  }
  if (waits) impl.answered.wait(lock, [&] { return impl.whole_answers == impl.wishes; });
  impl.news = false;
  return impl.picture;
}

bool LogStudy::hasNews() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->news || (impl_->made_table && !impl_->table_busy);
}

bool LogStudy::isBusy() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->wishes > impl_->whole_answers || impl_->table_busy || impl_->table_wish;
}

void LogStudy::writeTable(std::vector<SeriesKey> keys, LogTime from, LogTime until,
                          std::filesystem::path path) {
  Impl& impl = *impl_;
  std::unique_lock lock(impl.mutex);
  impl.table_wish = TableQuery{std::move(keys), from, until, std::move(path)};
  impl.asked.notify_all();
  if (waits) impl.answered.wait(lock, [&] { return impl.made_table.has_value(); });
}

std::optional<Result<std::string>> LogStudy::takeTable() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->made_table, std::nullopt);
}

}  // namespace rocinante
