#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/decode/decoder_set.h"
#include "core/net/datagram_source.h"
#include "core/recording/capture_writer.h"
#include "core/recording/hand_over.h"
#include "viewer/ui/live/kept_folder.h"
#include "viewer/ui/live/kept_pieces.h"

namespace rocinante {

/// What the kept log has so far.
struct KeptProgress {
  std::filesystem::path first;                  ///< its first piece; empty: nothing yet
  std::vector<std::filesystem::path> finished;  ///< the finished pieces, oldest first
  LogTime finished_until{};                     ///< everything before this is in them
  std::uint64_t datagrams = 0;                  ///< since the start
  std::uint64_t lost = 0;                       ///< by this machine, and counted in the log
  std::uint64_t bytes = 0;                      ///< of the pieces now kept
  std::string trouble;  ///< why nothing more is kept, or what befell a piece
};

/// Keeps what a live window hears in a log of its own (docs/decisions/016): a thread writes what
/// the network's thread hands over. The log is deleted with this object.
class LiveKeeper {
 public:
  using Decoders = std::shared_ptr<const decode::DecoderSet>;

  /// With `decoders`, the packets that they make are kept behind their octets. Makes a folder below
  /// `parent` (KeptFolder) and starts the thread. unreadable when the folder cannot be made.
  static Result<std::unique_ptr<LiveKeeper>> start(const std::filesystem::path& parent,
                                                   const KeepLimits& limits,
                                                   std::vector<ListenedEndpoint> endpoints,
                                                   Decoders decoders = nullptr);
  ~LiveKeeper();

  // For the network's thread.

  /// Adds a datagram that arrived at `time`; what finds no room is counted as lost.
  void add(std::uint32_t endpoint, LogTime time, const ReceivedDatagram& datagram);
  /// Datagrams of the endpoint that the kernel dropped between the two times.
  void addDropped(std::uint32_t endpoint, LogTime from, LogTime until, std::uint64_t count);
  void addStep(const ClockStep& step) { steps_.push_back(step); }
  /// To be called about every 10 ms: everything that arrived before `drained_until` was added.
  void pass(LogTime drained_until);

  // For the window's thread.

  KeptProgress progress() const;
  /// Asks that everything that arrived up to `moment` is soon in finished pieces.
  void finishUpTo(LogTime moment);
  /// While true no piece is deleted.
  void hold(bool held);
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  LiveKeeper(KeptFolder folder, const KeepLimits& limits, std::vector<ListenedEndpoint> endpoints,
             const Decoders& decoders);
  void write();
  void handOver(std::optional<LogTime> drained_until);

  KeptFolder folder_;
  HandOver queue_;
  KeptPieces* pieces_;  ///< of the writer
  CaptureWriter writer_;

  std::unique_ptr<DatagramBlock> block_;  ///< of the network's thread, as are the next
  std::vector<EndpointLoss> losses_;
  std::vector<ClockStep> steps_;

  mutable std::mutex mutex_;
  KeptProgress progress_;  ///< guarded by mutex_, as are the next
  std::optional<LogTime> finish_;
  bool held_ = false;
  std::thread thread_;  ///< last: it uses the members above
};

}  // namespace rocinante
