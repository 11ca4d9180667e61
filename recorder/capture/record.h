#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "core/foreign/decode/decoder_set.h"
#include "core/log/log_writer.h"
#include "core/net/address_filter.h"
#include "core/net/datagram_source.h"
#include "core/net/udp_socket.h"
#include "core/signing/trust_judge.h"
#include "recorder/capture/record_summary.h"
#include "recorder/pieces/note_box.h"
#include "recorder/pieces/ring_recording.h"

namespace rocinante {

/// A cell to attach, and the decoders that it names; null for none.
struct LoadedCell {
  std::shared_ptr<const CellBundle> cell;
  std::shared_ptr<const decode::DecoderSet> decoders;
};

struct RecordOptions {
  std::vector<Endpoint> endpoints;
  std::filesystem::path log;  ///< a file, a folder or a name pattern: recordPath()
  LogWriterOptions writing;
  /// Attached before anything is recorded; null for none.
  std::shared_ptr<const CellBundle> cell;
  /// Loads the cell on the caller's thread, in place of `cell` and where there are no `decoders`,
  /// after the endpoints are bound:
  /// datagrams wait in the queue meanwhile. Empty: `cell` is used.
  std::function<Result<LoadedCell>()> load_cell;
  bool attach_once = false;  ///< attach the cell to the first log only
  /// Decode what is not packet text, and are attached to each log; null for none.
  std::shared_ptr<const decode::DecoderSet> decoders;
  /// How long to wait for network interfaces that do not exist yet; empty: a missing one is an
  /// error.
  std::optional<Nanoseconds> wait_interface;
  SplitRule split;
  RetentionLimits limits;
  /// Writes only on a trigger; `split` is ignored.
  std::optional<RingRule> ring;
  std::vector<Condition> ring_on;
  /// Loads the cell that a ring's findings are judged with, after the endpoints are bound; empty:
  /// nothing is judged.
  std::function<Result<Cell>()> load_watched;
  Severity watch_severity = Severity::error;  ///< a finding this severe triggers the ring
  /// The watch itself; made by record().
  std::shared_ptr<FindingTrigger> watch;
  std::vector<Condition> start_on;
  std::vector<Condition> stop_on;
  UdpReceiver::Options receiving;
  AddressFilter allow;                  ///< datagrams from other senders are not recorded
  std::shared_ptr<TrustJudge> trust;    ///< if set, datagrams that it refuses are not recorded
  std::vector<Endpoint> tees;           ///< everything received is forwarded there
  std::optional<Nanoseconds> duration;  ///< on the session's time line, from its beginning
  std::optional<std::uint64_t> max_packets;
  std::size_t queue_blocks = 256;  ///< DatagramBlocks: 230 MB at most
};

/// Progress of a running recording.
struct RecordProgress {
  Nanoseconds elapsed{};
  std::uint64_t packets = 0;
  std::uint64_t lost = 0;       ///< by the kernel, the queue and the disk
  std::uint64_t log_bytes = 0;  ///< written in total
  bool started = true;          ///< false while waiting for a start condition
  Nanoseconds held{};           ///< span held by a ring
  double queue_fill = 0;        ///< 0 to 1; datagrams are lost at 1
  std::optional<std::uint64_t> disk_free_bytes;
};

/// Callbacks of a recording, all called on the caller's thread.
struct RecordEvents {
  /// The endpoints are bound and receiving; the cell is loaded next, before anything is written.
  std::function<void(const std::vector<std::string>&)> listening = [](const auto&) {};
  /// Everything is bound and open. Arguments: the endpoints with their bound ports, and the log.
  std::function<void(const std::vector<std::string>&, const std::string&)> ready =
      [](const auto&, const auto&) {};
  /// One sentence for each event of the files, as it happens.
  std::function<void(const NoteBox::Note&)> note = [](const auto&) {};
  /// A few times a second.
  std::function<void(const RecordProgress&)> progress = [](const auto&) {};
  /// Polled often; true ends the recording cleanly.
  std::function<bool()> stop_requested = [] { return false; };
  /// How many new pieces, and ring files, were requested since the beginning.
  std::function<std::uint32_t()> seams_requested = [] { return 0U; };
  std::function<std::uint32_t()> triggers_requested = [] { return 0U; };
};

/// Binds the endpoints, listens, loads the cell, creates the log and records until a limit or a
/// stop. Starts two threads: one receives, one writes; with pieces a third, which closes and
/// deletes them. Fails when nothing could be recorded; later failures are in the summary.
Result<RecordSummary> record(const RecordOptions& options, const RecordEvents& events);

/// The same from open sources into an existing log, the only one of the recording, to which the
/// caller has attached the decoders.
RecordSummary recordFrom(const std::vector<DatagramSource*>& sources, LogWriter log,
                         const RecordOptions& options, const RecordEvents& events);

}  // namespace rocinante
