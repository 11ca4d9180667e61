#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "recorder/contents/message_printer.h"
#include "recorder/copy/log_selection.h"

namespace rocinante {

struct CatOptions {
  /// Of it from, until, channels (none: the captured ones) and devices.
  SelectionOptions selection;
  CatFormat format = CatFormat::text;
  bool name_log = false;  ///< several logs are given: say with each message whose it is
};

/// Takes the next piece of output; an error ends the work.
using TextSink = std::function<Status(std::string_view)>;

/// Gives the chosen messages of a log, in order, one a line (of a CSV file: one a row, and its
/// first line names the columns when `with_header`). Marks beside the log are messages on
/// /rocinante/mark, at their times, behind the log's own. Answers how many there were.
Result<std::uint64_t> catLog(LogReader& reader, const CatOptions& options, bool with_header,
                             const TextSink& out);

}  // namespace rocinante
