#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/log/log_reader.h"
#include "core/series/series_scan.h"
#include "core/session/log_pieces.h"

namespace rocinante {

/// A stretch of a log, gathered a few messages at a time; one that follows a growing log goes on
/// with what is appended and with the next pieces. Not thread-safe.
class LogScan {
 public:
  /// From where `reader` stands until `until`. `follows`: it was opened as growing.
  LogScan(LogReader reader, SeriesScan::Options options, LogTime from, LogTime until,
          bool follows = false);

  /// Gathers about a thousand messages.
  Status step();
  bool ended() const { return ended_; }
  /// Continues a scan that has ended: true when there is more to read now.
  Result<bool> more();
  /// More may come.
  bool grows() const;
  /// The log is one that is read alone and grows no more: a part of it can be read again.
  bool isComplete() const { return !follows_ || (!grows() && !next_begun_); }
  /// The stretches of a value, if it has one, are no wider than this.
  bool isFine(const SeriesKey& key, Nanoseconds most) const;
  /// Counts the losses that were found since the last call.
  void addLosses();
  /// Times where packets may be missing.
  std::vector<std::pair<LogTime, LogTime>> damaged() const;

  SeriesScan& series() { return series_; }
  const SeriesScan& series() const { return series_; }
  LogTime from() const { return from_; }
  LogTime until() const { return until_; }

 private:
  LogReader reader_;
  SeriesScan series_;
  LogTime from_, until_;
  bool follows_ = false;
  bool ended_ = false;
  bool next_begun_ = false;
  std::optional<LogPosition> last_;  ///< of the last message read, in this piece
  std::size_t losses_added_ = 0;     ///< of this piece
  NextPiece next_piece_;
  std::vector<std::pair<LogTime, LogTime>> damaged_;  ///< of earlier pieces
};

}  // namespace rocinante
