#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "recorder/copy/log_make.h"

namespace rocinante {

/// Where a log is parted: one of these.
struct SplitOptions {
  std::uint64_t size_bytes = 0;  ///< no piece much larger; a message alone may be
  Nanoseconds time{0};           ///< every so often, counted from the session's origin
  std::string event;             ///< pattern: before each event whose text matches
  bool attach_once = false;      ///< attachments go into the first piece alone
};

struct SplitPiece {
  std::filesystem::path path;
  PieceCounts counts;
};

struct SplitReport {
  std::vector<SplitPiece> pieces;
  CopyReport whole;  ///< counts: the sum of the captured messages
};

/// The name of piece `number` (from 1): `%n` in the pattern is the number, three digits or more,
/// and `%%` a percent sign; without one, the number goes before the extension. A pattern that is a
/// folder, ends in a slash, or has neither number nor extension, stands for FOLDER/LOG-%n.mcap.
std::string pieceName(const std::string& pattern, const std::filesystem::path& log,
                      std::uint64_t number);

/// A log in pieces, each of which stands alone: it opens with what preceded it. Messages of one log
/// time are never parted, and those of all pieces, one after another, are those of the log. All
/// pieces appear, or none. `make.output` is the pattern.
Result<SplitReport> splitLog(const std::filesystem::path& log, const SplitOptions& split,
                             const MakeOptions& make);

}  // namespace rocinante
