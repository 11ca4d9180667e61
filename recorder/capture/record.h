#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "core/log/log_writer.h"
#include "core/net/address_filter.h"
#include "core/net/datagram_source.h"
#include "core/net/udp_socket.h"
#include "core/recording/capture_writer.h"
#include "recorder/capture/input_account.h"
#include "recorder/pieces/note_box.h"
#include "recorder/pieces/ring_recording.h"

namespace rocinante {

struct RecordOptions {
  std::vector<Endpoint> endpoints;
  std::filesystem::path log;  ///< a file, a folder or a pattern: recordPath()
  LogWriterOptions writing;
  /// Attached before anything is recorded; null: none.
  std::shared_ptr<const CellBundle> cell;
  /// Gives `cell` in its place, on the caller's thread, while the endpoints are heard already: what
  /// comes meanwhile waits in the queue. Empty: `cell` holds.
  std::function<Result<std::shared_ptr<const CellBundle>>()> load_cell;
  bool attach_once = false;  ///< to the first log alone
  /// How long to wait for network interfaces that do not exist yet; empty: one is refused at once.
  std::optional<Nanoseconds> wait_interface;
  SplitRule split;
  RetentionLimits limits;
  /// Nothing is written but what is asked for; `split` means nothing then.
  std::optional<RingRule> ring;
  std::vector<Condition> ring_on;
  std::vector<Condition> start_on;
  std::vector<Condition> stop_on;
  UdpReceiver::Options receiving;
  AddressFilter allow;                  ///< from elsewhere nothing is recorded
  std::vector<Endpoint> tees;           ///< everything received is sent on there
  std::optional<Nanoseconds> duration;  ///< of the session's time line, from where it begins
  std::optional<std::uint64_t> max_packets;
  std::size_t queue_blocks = 256;  ///< of DatagramBlock: 230 MB at most
};

/// How a recording that goes on stands.
struct RecordProgress {
  Nanoseconds elapsed{};
  std::uint64_t packets = 0;
  std::uint64_t lost = 0;       ///< by kernel, queue and disk
  std::uint64_t log_bytes = 0;  ///< ever written
  bool started = true;          ///< false while a condition is waited for
  Nanoseconds held{};           ///< what a ring holds
  double queue_fill = 0;        ///< 0 to 1: at 1 datagrams are lost
  std::optional<std::uint64_t> disk_free_bytes;
};

struct RecordSummary {
  std::filesystem::path log;  ///< the last one written; empty when there is none
  RecordedFiles files;
  std::vector<EndpointAccount> endpoints;
  std::vector<InputAccount> inputs;  ///< by endpoint too
  std::vector<Tee::Account> tees;
  std::uint64_t packets = 0;         ///< recorded: what the disk refused is not among them
  std::uint64_t restated = 0;        ///< of what was given to the log: said by someone else (`by=`)
  std::uint64_t payload_bytes = 0;   ///< of what was given to the log
  std::uint64_t packets_before = 0;  ///< heard before the recording began, and not recorded
  std::uint64_t log_bytes = 0;       ///< of the files that stay
  std::size_t channels = 0;
  Nanoseconds duration{};  ///< from the first moment to the last
  LossCounts losses;
  std::size_t late = 0;  ///< came too late to stand at their own time
  std::string reason;    ///< as rocinante.end has it
  /// What ended the recording before its time: the log or a socket refused.
  std::optional<Error> trouble;
  /// What was not done beside that, though everything received was kept: a file not made or
  /// deleted.
  std::vector<std::string> warnings;

  /// Everything that was recorded stands in the files.
  bool complete() const {
    return !trouble && std::ranges::none_of(files.pieces,
                                            [](const PieceFacts& each) { return !!each.trouble; });
  }
  std::uint64_t lost() const { return losses.kernel + losses.queue + losses.disk; }
};

/// What a recording asks of the program around it. All are called on the caller's thread.
struct RecordEvents {
  /// The endpoints are bound and heard, and a cell is read before anything is written.
  std::function<void(const std::vector<std::string>&)> listening = [](const auto&) {};
  /// Everything is bound and open; the endpoints with the ports that were bound, and the log.
  std::function<void(const std::vector<std::string>&, const std::string&)> ready =
      [](const auto&, const auto&) {};
  /// What happens to the files, as it happens: one sentence.
  std::function<void(const NoteBox::Note&)> note = [](const auto&) {};
  /// A few times a second.
  std::function<void(const RecordProgress&)> progress = [](const auto&) {};
  /// Asked often; true ends the recording cleanly.
  std::function<bool()> stop_requested = [] { return false; };
  /// How often a new piece, and the ring, have been asked for since the beginning.
  std::function<std::uint32_t()> seams_requested = [] { return 0U; };
  std::function<std::uint32_t()> triggers_requested = [] { return 0U; };
};

/// Binds the endpoints, listens, loads the cell, makes the log and records until a limit or a stop.
/// Starts two threads: one receives, one writes; with pieces a third, which closes and deletes
/// them. Fails when nothing could be recorded; what goes wrong later is in the summary.
Result<RecordSummary> record(const RecordOptions& options, const RecordEvents& events);

/// The same from sources already open, into a log already made, which stays the only one.
RecordSummary recordFrom(const std::vector<DatagramSource*>& sources, LogWriter log,
                         const RecordOptions& options, const RecordEvents& events);

}  // namespace rocinante
