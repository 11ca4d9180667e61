#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "core/base/result.h"
#include "core/log/log_reader.h"

namespace rocinante {

/// What programs say of a piece that stands alone.
inline constexpr const char* kGoesOn =
    "the recording goes on in another log, which is not beside this one";

/// Finds the piece of a recording that follows a finished one: a log in the same folder with the
/// same session id that begins where the other ends. Not for sharing between threads.
class NextPiece {
 public:
  /// The log says that its recorder continues in another piece.
  static bool expected(const LogReader& finished);

  /// It does, and that piece is not in its folder.
  static bool missing(const LogReader& finished);

  /// Empty when there is none, or none with a message yet. Other logs of the folder are opened once
  /// each time that they change.
  Result<std::optional<LogReader>> after(const LogReader& finished);

 private:
  /// Logs that are not the next piece, by path, as of their last change.
  std::map<std::filesystem::path, std::filesystem::file_time_type> others_;
};

}  // namespace rocinante
