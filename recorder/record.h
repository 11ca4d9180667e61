#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "core/log/log_writer.h"
#include "core/net/datagram_source.h"
#include "core/net/udp_socket.h"
#include "recorder/capture_writer.h"

namespace rocinante {

struct RecordOptions {
  std::vector<Endpoint> endpoints;
  std::filesystem::path log;
  LogWriterOptions writing;
  /// Attached before anything is recorded; null: none.
  std::shared_ptr<const CellBundle> cell;
  UdpReceiver::Options receiving;
  std::optional<Nanoseconds> duration;  ///< of the session's time line, from the first moment
  std::optional<std::uint64_t> max_packets;
  std::size_t queue_blocks = 256;  ///< of DatagramBlock: 230 MB at most
};

/// How a recording that goes on stands.
struct RecordProgress {
  Nanoseconds elapsed{};
  std::uint64_t packets = 0;
  std::uint64_t lost = 0;  ///< by kernel, queue and disk
  std::uint64_t log_bytes = 0;
};

struct RecordSummary {
  std::filesystem::path log;
  std::vector<EndpointAccount> endpoints;
  std::uint64_t packets = 0;        ///< recorded: what the disk refused is not among them
  std::uint64_t restated = 0;       ///< of what was given to the log: said by someone else (`by=`)
  std::uint64_t payload_bytes = 0;  ///< of what was given to the log
  std::uint64_t log_bytes = 0;
  std::size_t channels = 0;
  Nanoseconds duration{};  ///< from the first moment to the last
  LossCounts losses;
  std::size_t late = 0;  ///< came too late to stand at their own time
  std::string reason;    ///< as rocinante.end has it
  /// What ended the recording before its time: the log or a socket refused.
  std::optional<Error> trouble;

  std::uint64_t lost() const { return losses.kernel + losses.queue + losses.disk; }
};

/// What a recording asks of the program around it. All are called on the caller's thread.
struct RecordEvents {
  /// Everything is bound and open; the endpoints with the ports that were bound.
  std::function<void(const std::vector<std::string>&)> ready = [](const auto&) {};
  /// A few times a second.
  std::function<void(const RecordProgress&)> progress = [](const auto&) {};
  /// Asked often; true ends the recording cleanly.
  std::function<bool()> stop_requested = [] { return false; };
};

/// Binds the endpoints, makes the log and records until a limit or a stop. Starts two threads: one
/// receives, one writes. Fails when nothing could be recorded; what goes wrong later is in the
/// summary.
Result<RecordSummary> record(const RecordOptions& options, const RecordEvents& events);

/// The same from sources already open, into a log already made.
RecordSummary recordFrom(const std::vector<DatagramSource*>& sources, LogWriter log,
                         const RecordOptions& options, const RecordEvents& events);

}  // namespace rocinante
