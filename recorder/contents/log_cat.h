#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/copy/log_selection.h"
#include "core/log/log_reader.h"
#include "recorder/contents/message_printer.h"

namespace rocinante {

struct CatOptions {
  /// Uses from, until, channels (none: the captured ones) and devices.
  SelectionOptions selection;
  CatFormat format = CatFormat::text;
  bool name_log = false;  ///< several logs are given: name the log of each message
};

/// Receives the next piece of output; an error ends the work.
using TextSink = std::function<Status(std::string_view)>;

/// Prints the chosen messages of a log in order, one per line (one per row in CSV, after a line
/// with the column names if `with_header`). Marks beside the log are messages on /rocinante/mark,
/// after the log's own of the same time. Returns the number of messages.
Result<std::uint64_t> catLog(LogReader& reader, const CatOptions& options, bool with_header,
                             const TextSink& out);

}  // namespace rocinante
