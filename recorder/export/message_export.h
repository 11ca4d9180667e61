#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/foreign/session/exported_mcap.h"
#include "core/foreign/session/session_format.h"
#include "core/report/account.h"
#include "core/session/moment_walk.h"
#include "recorder/export/log_table.h"
#include "recorder/export/timed_notes.h"

namespace rocinante {

struct MessageExportOptions {
  LogTime from{}, until{};
  bool raw = false;              ///< the captured datagrams too, on their own channels
  bool shapes = false;           ///< what devices show too; the cell needs its geometry
  std::vector<TimedNote> notes;  ///< more to say among the events; those outside the span are not
  ExportProgress progress;       ///< may be empty
};

struct MessageExportReport {
  std::vector<std::string> gaps;  ///< what is missing in the file
  Account left_out;               ///< what its format has no messages for
};

/// Writes what a session says in [from, until) as the messages of `format`: spaces and joints of a
/// device at each moment that writes or moves it, the drawings of a source when they change, events
/// and losses. `cell` is borrowed; null: there are no links, and only joints that packets name. The
/// caller finishes the file.
Result<MessageExportReport> exportMessages(MomentWalk& session, const Cell* cell,
                                           SessionFormat& format, ExportedMcap& out,
                                           const MessageExportOptions& options);

}  // namespace rocinante
