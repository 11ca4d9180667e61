#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/foreign/session/exported_mcap.h"
#include "core/foreign/session/session_format.h"
#include "core/foreign/table/session_table.h"
#include "core/foreign/table/table_writer.h"
#include "core/log/log_reader.h"
#include "core/report/account.h"
#include "core/session/moment_walk.h"
#include "recorder/export/clearance_columns.h"
#include "recorder/export/derived_columns.h"
#include "recorder/export/link_columns.h"
#include "recorder/export/timed_notes.h"
#include "recorder/gltf/gltf_recording.h"
#include "recorder/pcap/pcap_file.h"

namespace rocinante {

/// Receives how much is done, 0 to 1; an error ends the work.
using ExportProgress = std::function<Status(double)>;

struct TableOptions {
  enum class Rows {
    written,  ///< at each moment that writes a device of the table
    changed,  ///< of those, where a value differs from the row before
    grid,     ///< at each `every`, from `from` on
  } rows = Rows::written;
  Nanoseconds every{};  ///< grid: above 0
  LogTime from{}, until{};
  ExportProgress progress;                 ///< may be empty
  LinkColumns* links = nullptr;            ///< behind the table's own columns; borrowed
  DerivedColumns* derived = nullptr;       ///< behind those; borrowed
  ClearanceColumns* clearances = nullptr;  ///< behind the other columns; borrowed
  bool signals = false;                    ///< the table has them: for what is left out
};

struct TableReport {
  std::uint64_t rows = 0;
  std::vector<std::string> columns;
  Account left_out;  ///< what has no column
};

/// Writes the states of a session in [from, until) as a table. Two passes over the log: one finds
/// the columns, one writes the rows. not_found when no chosen device has joints or a pose.
Result<TableReport> writeTable(MomentWalk& session, SessionTable& table, TableWriter& writer,
                               const TableOptions& options);

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

struct GltfExportOptions {
  LogTime from{}, until{};
  Nanoseconds every{};      ///< 0: at each moment that says anything
  ExportProgress progress;  ///< may be empty
};

/// Gives `recording` the scene at the moments of [from, until). One pass over the log. not_found
/// when there is no moment. Adds to `left_out` what of the log the scene has no place for.
Status recordGltf(MomentWalk& session, const Cell& cell, GltfRecording& recording,
                  const GltfExportOptions& options, Account& left_out);

struct PcapExportReport {
  std::uint64_t datagrams = 0;
  std::vector<std::string> gaps;
  std::vector<std::string> notes;
  Account left_out;  ///< what is no datagram
};

/// Writes the captured datagrams of [from, until), and those restated by other programs, as
/// traffic: from the sender's address to the one listened at, by the channel's metadata. Where a
/// log has no address (a NATS subject), addresses of 192.0.2.0/24 stand for it; an endpoint that
/// listened at every address is 127.0.0.1 or ::1.
Result<PcapExportReport> exportPcap(LogReader& log, LogTime from, LogTime until, PcapFile& out,
                                    const ExportProgress& progress);

}  // namespace rocinante
