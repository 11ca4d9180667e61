#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/playback_speed.h"
#include "core/packet/packet_text.h"
#include "core/packet/restatement.h"
#include "core/packet/session_state.h"
#include "player/logs/multi_log_reader.h"
#include "player/send/datagram_stream.h"
#include "player/source/log_speaker.h"

namespace rocinante {

/// A recorded session as live sources (docs/programs/source.md): each SOURCE with its own name, a
/// new RUN, SEQUENCE from 0 and TIME of now, and its statements as recorded, at their places in
/// time. What newest wins drops is not sent. Each source restates its state at the start, at the
/// start of each loop (so what a loop has added is gone) and one source after another in between.
class LogStream final : public DatagramStream {
 public:
  struct Options {
    LogChoice choice;
    std::string run;
    PlayedSpan span;          ///< sent `turns` times, one after the other; at least 1 ms long
    std::uint32_t turns = 1;  ///< 0: endless
    /// Log time in which each source restates itself once; 0: only at the start of each loop.
    Nanoseconds restate{};
    std::size_t mtu_bytes = 1200;  ///< a larger recorded packet is sent as several
    PlaybackSpeed speed;           ///< TIME advances in real time
    std::int64_t epoch_ns = 0;     ///< TIME at the start, nanoseconds since the epoch
  };

  /// `log` must outlive the stream, and belongs to it until then; `before` is the state at the
  /// start of the span. not_found when there is nothing to send; bad_argument when two sources
  /// would have one name.
  static Result<LogStream> open(MultiLogReader& log, SessionState before, Options options);

  Result<std::optional<Due>> due() override;
  ByteView take() override;

  /// The names that have been given so far, sorted.
  std::vector<std::string> names();

 private:
  struct Pending {
    Due due;
    std::string text;
  };

  LogStream(MultiLogReader& log, SessionState before, Options options);

  LogTime turnEnd() const { return options_.span.until + shift_; }
  Status prepare();
  Status readHead();
  Status sendHead();
  Status beginTurn();
  Status restateThese(const std::set<std::string, std::less<>>& sources, LogTime moment);
  Status say(LogSpeaker& speaker, PacketHeader header, const std::vector<std::string_view>& lines,
             LogTime moment);
  RestatementOptions restatementOptions(std::string_view part_id) const;

  MultiLogReader* log_;
  Options options_;
  SessionState before_;
  SessionState state_;  ///< the fold of the log at this place
  LogSpeakers speakers_;
  std::unique_ptr<PacketTextDecoder> decoder_;
  std::unique_ptr<PacketTextDecoder> restated_decoder_;
  Nanoseconds shift_{};  ///< from log time to the stream's line
  std::uint32_t turn_ = 0;
  bool has_spoken_ = false;  ///< in this turn
  std::optional<LogMessage> head_;
  bool head_read_ = false;
  std::vector<Pending> pending_;
  std::size_t taken_ = 0;
};

}  // namespace rocinante
