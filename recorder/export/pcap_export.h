#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/pcap/pcap_file.h"
#include "core/log/log_reader.h"
#include "core/report/account.h"
#include "recorder/export/log_table.h"

namespace rocinante {

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
