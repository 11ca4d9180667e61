#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/log/log_reader.h"
#include "core/series/series_scan.h"
#include "core/session/moment_walk.h"

namespace rocinante {

/// What is derived of a session's values as columns of a table, in the words of the window's plots:
/// `d/dt VALUE`, `mean SECONDS VALUE`, `VALUE - VALUE`. Radians, metres and the signals' units, by
/// seconds; NaN in a gap and before there is one. It reads the log once more beside the table's own
/// passes, in bounded memory. The cell must outlive it.
class DerivedColumns {
 public:
  /// `cell`: of links and of the names of positional joints; null: none. `log`: the session's.
  /// bad_argument for a text that is none of these or needs a cell, not_found for a link that
  /// neither the cell nor the session at its end has.
  static Result<DerivedColumns> of(const Cell* cell, const std::vector<std::string>& texts,
                                   const std::filesystem::path& log, MomentWalk& session);

  const std::vector<std::string>& columns() const { return columns_; }

  /// The first pass: what holds as it begins, then every message.
  void notice(const SessionState& state) { known_->beginWith(state); }
  void notice(const LogMessage& message) { known_->add(message); }
  /// Ends it. not_found for a value that no packet stated, with what `others`, the table's columns,
  /// have; bad_argument for one that is a text.
  Status layOut(const std::vector<std::string>& others);

  /// The second pass: begins anew, for moments from `from` on.
  Status begin(MomentWalk& session, LogTime from);
  /// On to a moment, which does not go back.
  Status moveTo(LogTime moment);
  /// A sample of which something is derived came with the last moveTo().
  bool wereSampled() const { return were_sampled_; }
  /// `row` is as long as columns().
  void fill(std::span<double> row) const;

 private:
  DerivedColumns(const Cell* cell, std::filesystem::path log)
      : cell_(cell), path_(std::move(log)) {}

  std::unique_ptr<SeriesScan> scanOf(const std::set<SeriesKey>& keys, LogTime from) const;
  std::set<SeriesKey> statedKeys() const;

  const Cell* cell_;
  std::filesystem::path path_;
  std::vector<SeriesKey> keys_;
  std::vector<std::string> columns_;
  std::unique_ptr<SeriesScan> known_;    ///< of the first pass: what they are made of
  std::unique_ptr<SeriesScan> derived_;  ///< of the second
  std::optional<LogReader> log_;
  std::optional<LogMessage> next_;  ///< the first behind the moment; borrowed from `log_`
  bool were_sampled_ = false;
};

}  // namespace rocinante
