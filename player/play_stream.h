#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "player/datagram_stream.h"
#include "player/log_merge.h"
#include "player/played_span.h"

namespace rocinante {

/// A span of a session as datagrams to be sent: each turn the restatement of the state at its
/// beginning, then the log's captured messages of [from, until), byte for byte. Turn n lies n times
/// the span's length later on one time line, so that turns follow each other without a gap and
/// without drift.
class PlayStream final : public DatagramStream {
 public:
  struct Options {
    PlayedSpan span;
    std::uint32_t turns = 1;  ///< 0: endless
    bool restate = true;
    /// The first restatement is due this much before `from`, so that it delays no message.
    Nanoseconds restate_ahead{0};
  };

  /// `logs` must outlive the stream and belongs to it until then. When `restate` is set, the logs
  /// are folded up to the span's beginning now.
  static Result<PlayStream> open(LogMerge& logs, const Options& options);

  Result<std::optional<Due>> due() override;
  ByteView take() override;

 private:
  PlayStream(LogMerge& logs, const Options& options) : logs_(&logs), options_(options) {}

  Status beginTurn(std::uint32_t turn);
  LogTime shifted(LogTime time) const;

  LogMerge* logs_;
  Options options_;
  StateBefore before_;
  std::uint32_t turn_ = 0;
  bool over_ = false;
  std::vector<std::string> restatement_;  ///< of this turn
  std::size_t restated_ = 0;              ///< how much of it was taken
  std::optional<LogMessage> head_;
  bool head_taken_ = true;
};

}  // namespace rocinante
