#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/copy/log_make.h"

namespace rocinante {

/// Where to split a log: one of these.
struct SplitOptions {
  std::uint64_t size_bytes = 0;  ///< size of a piece; a single message may exceed it
  Nanoseconds time{0};           ///< interval, counted from the session's origin
  std::string event;             ///< pattern; split before each event whose text matches
  bool attach_once = false;      ///< attachments go into the first piece only
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
/// and `%%` a percent sign; without `%n`, the number goes before the extension. A pattern that is a
/// folder, ends in a slash, or has neither number nor extension, means FOLDER/LOG-%n.mcap.
std::string pieceName(const std::string& pattern, const std::filesystem::path& log,
                      std::uint64_t number);

/// Splits a log into self-contained pieces, each of which opens with the state before it. Messages
/// of one log time stay together, and the pieces in order hold exactly the messages of the log. All
/// pieces appear, or none. `make.output` is the pattern.
Result<SplitReport> splitLog(const std::filesystem::path& log, const SplitOptions& split,
                             const MakeOptions& make);

}  // namespace rocinante
