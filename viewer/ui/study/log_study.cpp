#include "viewer/ui/study/log_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "core/log/log_reader.h"
#include "core/series/series_table.h"
#include "core/session/timeline.h"
#include "viewer/shown/positional_names.h"
#include "viewer/ui/study/log_scan.h"
#include "viewer/ui/study/source_strips.h"
#include "viewer/ui/study/study_thread.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMaxColumns = 8192;
/// How often pictures show what has been read so far.
constexpr Nanoseconds kShowEvery = 100ms;
/// How often a growing log is looked at.
constexpr Nanoseconds kLookEvery = 150ms;

SteadyTime studyNow() { return std::chrono::steady_clock::now(); }

struct TableWish {
  std::vector<SeriesKey> keys;
  LogTime from{}, until{};
  std::filesystem::path path;
};

}  // namespace

std::shared_ptr<const StudyPicture> alignedPicture(const StudyPicture& beside,
                                                   const StudyWish& wish,
                                                   const EventAlignment& alignment) {
  auto aligned = std::make_shared<StudyPicture>();
  aligned->wish = wish;
  aligned->wish.keys = beside.wish.keys;
  aligned->whole = beside.whole;
  const Nanoseconds known = beside.wish.until - beside.wish.from;
  for (const std::vector<ValueColumn>& curve : beside.curves) {
    std::vector<ValueColumn>& columns = aligned->curves.emplace_back();
    if (curve.empty() || known.count() <= 0) continue;
    columns.resize(wish.columns);
    const double count = static_cast<double>(curve.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      // The middle of the column.
      const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(columns.size());
      const Nanoseconds since(
          static_cast<std::int64_t>(part * static_cast<double>((wish.until - wish.from).count())));
      const LogTime there = alignment.inB(wish.from + since);
      const double place = static_cast<double>((there - beside.wish.from).count()) /
                           static_cast<double>(known.count()) * count;
      if (place >= 0 && place < count) columns[i] = curve[static_cast<std::size_t>(place)];
    }
  }
  return aligned;
}

struct LogStudy::Impl {
  Impl(const Cell& the_cell, std::filesystem::path path, bool grows)
      : names(positionalNames(the_cell)), log(std::move(path)), follows(grows) {}

  void work(const std::stop_token& stop);
  Status begin(const std::stop_token& stop);
  Status readAll(const std::stop_token& stop);
  Result<bool> readMore(const std::stop_token& stop);
  Status answer(const StudyWish& wish, const std::stop_token& stop);
  Status refine(const StudyWish& wish, const std::stop_token& stop);
  bool isFineEnough(const StudyWish& wish) const;
  void publish(const StudyWish& wish, const LogScan& scan, bool whole);
  Result<std::string> tableOf(const TableWish& wish, const std::stop_token& stop);
  Result<SessionState> stateAt(LogTime moment);
  StudyWish wished() {
    const std::lock_guard lock(mutex);
    return newest;
  }

  // Of the thread.
  PositionalNames names;
  std::filesystem::path log;
  bool follows;
  std::optional<Timeline> timeline;
  LogTime start{}, end{};
  std::unique_ptr<LogScan> all, part;
  SteadyTime looked{};  ///< whether the log has grown
  std::set<SeriesKey> part_keys;

  std::mutex mutex;
  std::condition_variable_any asked, answered;
  // Guarded by mutex.
  StudyWish newest;
  std::uint64_t wishes = 0;         ///< number of the newest
  std::uint64_t whole_answers = 0;  ///< number of the newest answered wholly
  std::shared_ptr<const StudyPicture> picture;
  bool news = false;
  std::optional<TableWish> table_wish;
  bool table_busy = false;
  std::optional<Result<std::string>> made_table;
  std::string fault;

  std::jthread thread;  // last: it ends first
};

LogStudy::LogStudy(const Cell& cell, std::filesystem::path log, bool grows)
    : impl_(std::make_unique<Impl>(cell, std::move(log), grows)) {
  Impl& my = *impl_;
  my.thread = std::jthread([&my](const std::stop_token& stop) { my.work(stop); });
}

LogStudy::~LogStudy() = default;

Status LogStudy::Impl::begin(const std::stop_token& stop) {
  auto reader = follows ? LogReader::openGrowing(log) : LogReader::open(log);
  if (!reader.ok()) return reader.error();
  auto second = follows ? LogReader::openGrowing(log) : LogReader::open(log);
  if (!second.ok()) return second.error();
  timeline = Timeline::of(std::move(*second));
  timeline->useStop(stop);
  start = timeline->start();
  end = timeline->end();
  SeriesScan::Options options;
  options.from = start;
  options.until = end;
  options.names = names;
  if (Status there = reader->rewind(); !there) return there;
  all = std::make_unique<LogScan>(std::move(*reader), std::move(options), start, LogTime::max(),
                                  follows);
  return {};
}

Status LogStudy::Impl::readAll(const std::stop_token& stop) {
  SteadyTime shown = studyNow();
  StudyWish last;
  while (!all->ended() && !stop.stop_requested()) {
    if (Status read = all->step(); !read) return read;
    const StudyWish wanted = wished();
    if (wanted.strip_columns == 0 && wanted.columns == 0) continue;
    if (wanted == last && studyNow() - shown < kShowEvery) continue;
    publish(wanted, *all, false);
    last = wanted;
    shown = studyNow();
  }
  all->addLosses();
  end = std::max(end, all->series().reached());
  return {};
}

/// What was appended since; true when there was something.
Result<bool> LogStudy::Impl::readMore(const std::stop_token& stop) {
  if (!all->grows() || studyNow() - looked < kLookEvery) return false;
  looked = studyNow();
  bool any = false;
  while (!stop.stop_requested()) {
    const auto more = all->more();
    if (!more.ok() || !*more) return more.ok() ? Result<bool>(any) : more;
    any = true;
    if (Status read = readAll(stop); !read) return read.error();
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
bool LogStudy::Impl::isFineEnough(const StudyWish& wish) const {
  const Nanoseconds pixel =
      (wish.until - wish.from) / std::max<std::int64_t>(static_cast<std::int64_t>(wish.columns), 1);
  return std::ranges::all_of(wish.keys, [&](const SeriesKey& key) {
    const ValueBins* const values = key.isValue() ? all->series().values(key) : nullptr;
    return values == nullptr || values->width() <= std::max(pixel, Nanoseconds(1));
  });
}

/// Reads the part that is shown once more, and a little on both sides, until another wish comes.
Status LogStudy::Impl::refine(const StudyWish& wish, const std::stop_token& stop) {
  const Nanoseconds span = wish.until - wish.from;
  const Nanoseconds pixel = std::max(
      Nanoseconds(1), span / std::max<std::int64_t>(static_cast<std::int64_t>(wish.columns), 1));
  std::set<SeriesKey> keys(wish.keys.begin(), wish.keys.end());
  const bool known = part && part->ended() && part->from() <= wish.from &&
                     part->until() >= wish.until &&
                     (part->until() - part->from()) / 16384 <= pixel && part_keys == keys;
  if (!known) {
    part.reset();
    const Nanoseconds beside = span / 2;
    const LogTime from = std::max(start, wish.from - std::min(beside, wish.from - start));
    const LogTime until = wish.until + std::min(beside, std::max(Nanoseconds(0), end - wish.until));
    auto before = stateAt(from);
    if (!before.ok()) return before.error();
    auto reader = LogReader::open(log);
    if (!reader.ok()) return reader.error();
    if (Status there = reader->seek(from + Nanoseconds(1)); !there) return there;
    SeriesScan::Options options;
    options.from = from;
    options.until = until;
    options.names = names;
    options.only = keys;
    auto scan = std::make_unique<LogScan>(std::move(*reader), std::move(options), from, until);
    scan->series().beginWith(std::move(*before));
    while (!scan->ended()) {
      if (Status read = scan->step(); !read) return read;
      if (stop.stop_requested() || !(wished() == wish)) return {};
    }
    part = std::move(scan);
    part_keys = std::move(keys);
  }
  publish(wish, *part, true);
  return {};
}

void LogStudy::Impl::publish(const StudyWish& wish, const LogScan& scan, bool whole) {
  auto made = std::make_shared<StudyPicture>();
  made->wish = wish;
  made->reached = all->ended() ? end : all->series().reached();
  made->whole = whole;
  const auto strip = [&](const std::string& name, const SourceSeries& source) {
    made->strips.push_back(stripOf(name, source, wish, {start, end}, made->reached));
  };
  strip("", all->series().all());
  for (const auto& [name, source] : all->series().sources()) strip(name, source);
  const bool cut = !all->ended() || all->grows();
  for (const SeriesKey& key : wish.keys) {
    std::vector<ValueColumn> columns;
    if (key.isValue()) {
      const ValueBins* const values = scan.series().values(key);
      if (values != nullptr) columns = values->columns(wish.from, wish.until, wish.columns);
      // Nothing is known behind what was read: a curve ends there.
      for (std::size_t i = 0; cut && i < columns.size(); ++i) {
        const auto at = static_cast<std::int64_t>(i);
        if (wish.from + (wish.until - wish.from) / static_cast<std::int64_t>(columns.size()) * at >
            made->reached) {
          columns[i].held.reset();
        }
      }
    } else {
      columns = rateColumns(key, all->series(), wish, made->reached);
    }
    made->curves.push_back(std::move(columns));
  }
  made->damaged = all->damaged();
  const std::lock_guard lock(mutex);
  made->fault = fault;
  picture = std::move(made);
  news = true;
}

Result<std::string> LogStudy::Impl::tableOf(const TableWish& wish, const std::stop_token& stop) {
  auto before = stateAt(wish.from);
  if (!before.ok()) return before.error();
  auto reader = LogReader::open(log);
  if (!reader.ok()) return reader.error();
  SeriesTable table;
  table.keys = wish.keys;
  table.from = wish.from;
  table.until = wish.until;
  table.names = names;
  table.goes_on = [&stop] { return !stop.stop_requested(); };
  const auto rows = writeSeriesTable(table, std::move(*before), *reader, wish.path);
  if (!rows.ok()) return rows.error();
  return fmt::format("{}: {} rows", wish.path.string(), *rows);
}

/// A log that grows is known as finely as it was gathered.
Status LogStudy::Impl::answer(const StudyWish& wish, const std::stop_token& stop) {
  const bool fine = !all->isComplete() || isFineEnough(wish);
  publish(wish, *all, fine);
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
    StudyWish wanted;
    std::uint64_t number = 0;
    std::optional<TableWish> next_table;
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

std::shared_ptr<const StudyPicture> LogStudy::show(const StudyWish& wish) {
  Impl& my = *impl_;
  std::unique_lock lock(my.mutex);
  StudyWish bounded = wish;
  bounded.columns = std::min(wish.columns, kMaxColumns);
  bounded.strip_columns = std::min(wish.strip_columns, kMaxColumns);
  if (!(bounded == my.newest) || my.wishes == 0) {
    my.newest = std::move(bounded);
    ++my.wishes;
    my.asked.notify_all();
  }
  if (waits) my.answered.wait(lock, [&] { return my.whole_answers == my.wishes; });
  my.news = false;
  return my.picture;
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
  Impl& my = *impl_;
  std::unique_lock lock(my.mutex);
  my.table_wish = TableWish{std::move(keys), from, until, std::move(path)};
  my.asked.notify_all();
  if (waits) my.answered.wait(lock, [&] { return my.made_table.has_value(); });
}

std::optional<Result<std::string>> LogStudy::takeTable() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->made_table, std::nullopt);
}

}  // namespace rocinante
