#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/foreign/decode/decode_account.h"
#include "core/net/datagram_source.h"
#include "core/recording/capture_writer.h"
#include "core/report/account.h"
#include "recorder/capture/input_loop.h"
#include "recorder/capture/tee.h"

namespace rocinante {

/// Counts of datagrams that an endpoint neither recorded nor lost, and whether its buffer was large
/// enough.
struct InputAccount {
  std::string endpoint;  ///< with the bound port
  InputCounts counts;
  std::optional<SubscriptionOutcome> subscription;  ///< empty: it is not one
  Account left_out;                                 ///< by kind: frames that became no datagram
  std::uint64_t buffer_granted_bytes = 0;           ///< 0: no receive buffer
  std::uint64_t buffer_needed_bytes = 0;            ///< to survive a stall in its busiest second
};

/// One per source. Not while the loop runs.
std::vector<InputAccount> inputAccounts(const std::vector<DatagramSource*>& sources,
                                        const InputLoop& loop);

/// The account of a finished recording.
struct RecordSummary {
  std::filesystem::path log;  ///< the last one written; empty for none
  RecordedFiles files;
  std::vector<EndpointAccount> endpoints;
  std::vector<InputAccount> inputs;  ///< one per endpoint
  std::vector<Tee::Account> tees;
  /// Of the decoders, if there were any.
  std::optional<decode::DecodeAccount> decoded;
  std::uint64_t packets = 0;         ///< recorded; those the disk refused are not counted
  std::uint64_t restated = 0;        ///< given to the log and restated by another sender (`by=`)
  std::uint64_t payload_bytes = 0;   ///< of datagrams given to the log
  std::uint64_t packets_before = 0;  ///< received before the start condition, and not recorded
  std::uint64_t log_bytes = 0;       ///< of the files that are kept
  std::size_t channels = 0;
  Nanoseconds duration{};  ///< from the first moment to the last
  /// From the beginning of receiving to the first datagram of `packets`; empty: there is none, or
  /// the endpoint is a stream, whose times are its own.
  std::optional<Nanoseconds> first_after;
  LossCounts losses;
  std::size_t late = 0;  ///< came too late to be written at their own time
  std::string reason;    ///< as in rocinante.end
  /// The failure of the log or a socket that ended the recording early.
  std::optional<Error> trouble;
  /// File operations that failed (a file not made or deleted); no datagram was lost.
  std::vector<std::string> warnings;

  /// True if the files hold everything that was recorded.
  bool complete() const {
    return !trouble && std::ranges::none_of(files.pieces,
                                            [](const PieceFacts& each) { return !!each.trouble; });
  }
  /// Not in the log, or not whole.
  std::uint64_t lost() const {
    return losses.kernel + losses.queue + losses.disk + losses.truncated;
  }
};

/// What the writer has written, after its close(); the rest is left for the caller. `received` is
/// the end of receiving: trouble, unless the writer had its own.
RecordSummary summaryOf(const CaptureWriter& writer, const Status& received);

}  // namespace rocinante
