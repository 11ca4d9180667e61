#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/check/log_account.h"
#include "core/log/log_reader.h"
#include "core/packet/session_state.h"
#include "recorder/contents/activity.h"

namespace rocinante {

/// Events beyond these are only counted, unless all are asked for.
inline constexpr std::size_t kMaxEvents = 1000;

struct ChannelInfo {
  LogChannel channel;
  std::uint64_t messages = 0;
  LogTime first{};
  LogTime last{};
  Activity::Parts activity{};
  Nanoseconds longest_gap{0};  ///< between consecutive messages
  LogTime gap_from{};          ///< the message before it

  /// Messages per second between the first and the last; 0 with fewer than two.
  double rateHz() const;
};

/// The facts of `rocinante log info` (docs/programs/log.md). Counted by reading every message, so
/// that they are true of damaged logs too.
struct LogInfo {
  std::string name;
  LogSummary summary;  ///< as the log states it
  LogStorage storage;
  std::uint64_t messages = 0;             ///< captured, as read
  std::vector<ChannelInfo> channels;      ///< captured, by id
  std::vector<ChannelInfo> own_channels;  ///< /rocinante/...
  std::uint64_t keyframes = 0;
  std::uint64_t packets = 0;  ///< captured messages that could be decoded
  std::uint64_t decoded = 0;  ///< captured messages of which decoders made packets
  std::uint64_t events = 0;   ///< in packets, and marks in the log and beside it
  std::uint64_t marks = 0;    ///< of the events
  /// The first `max_events`, in time order.
  std::vector<Event> first_events;
  LossCounts losses;
  std::uint64_t source_gap = 0;  ///< SEQUENCE numbers that never came, over all sources
  std::vector<LossSpan> loss_spans;
  std::vector<LogAttachment> attachments;
  LogAccount account;  ///< with the cell that the log carries
  std::vector<DamageSpan> damage;
  std::string content_sha256;
  std::string decoded_sha256;  ///< empty without decoded packets
  std::string stream_sha256;   ///< of the payloads only, as in the player's report
};

/// Reads the whole log and its marks. Fails when the marks are malformed. `progress` is called with
/// the fraction done, 0 to 1.
Result<LogInfo> logInfo(const std::filesystem::path& path,
                        const std::function<void(double)>& progress = {},
                        std::size_t max_events = kMaxEvents);

/// One JSON object for scripts, indented or on one line, with LF.
std::string logInfoJson(const LogInfo& info, bool indented);

/// Several lines for the user, each with LF. `columns`: of a terminal, whose lines it fits and
/// which shows what is wrong first; 0: none, lines of any length in the order of the log.
std::string logInfoText(const LogInfo& info, std::size_t columns = 0);

}  // namespace rocinante
