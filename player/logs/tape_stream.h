#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/session/message_folder.h"
#include "player/logs/multi_log_reader.h"
#include "player/logs/play_routes.h"
#include "player/logs/restated_block.h"
#include "player/send/datagram_stream.h"

namespace rocinante {

/// The plan for playing from a place, without further commands.
struct TapeRun {
  TapePosition from;       ///< the first message is at or after this
  LogTime start{};         ///< start of the time line: the moment of `from`
  PlayedSpan bounds;       ///< of the first span, which ends at `bounds.until`
  std::uint32_t span = 0;  ///< its number

  PlayedSpan turn;  ///< span to repeat afterwards
  std::uint32_t turns_left = 0;
  bool endless = false;

  /// The states at `from` and at the beginning of each turn, to make restatements of. Empty: no
  /// restatements.
  std::optional<SessionState> state;
  std::optional<SessionState> turn_state;
  std::set<std::string> sources;         ///< to be reset
  std::optional<Nanoseconds> repeat;     ///< log time between restatements
  std::string part_id = "player";        ///< prefix of restatement IDs
  std::size_t restated_bytes = 1200;     ///< the largest datagram of a restatement
  std::optional<Nanoseconds> gap_limit;  ///< longest silence, in log time
};

/// Streams the log's captured messages from a place on, unchanged and in order, turn after turn.
/// Turns follow each other without a gap and without drift on one time line; long silences are cut
/// out of it. The player's restatements come between messages:
/// - of the state at the beginning of each turn;
/// - when `repeat` has passed since the last one, before the next message;
/// - where the log holds restatements by others, which are folded but not played: a receiver of the
///   player has no other source for them;
/// - after each part of a source's own restatement that was unfinished when the player's last one
///   came: a receiver has only the rest of it and cannot tell what to forget. At most 64 times.
/// The restatement of the state at `from` itself is left to the caller.
class TapeStream final : public DatagramStream {
 public:
  /// `logs` and `routes` must outlive the stream; `logs` belongs to it until then.
  static Result<TapeStream> open(MultiLogReader& logs, const PlayRoutes& routes, TapeRun run);

  Result<std::optional<Due>> due() override;
  ByteView take() override;

 private:
  TapeStream(MultiLogReader& logs, const PlayRoutes& routes, TapeRun run);

  Status readHead();
  Status beginTurn();
  bool isBlockWanted(LogTime moment) const;
  void makeBlock(TapePosition place, LogTime moment);
  Due headDue() const;

  MultiLogReader* logs_;
  const PlayRoutes* routes_;
  TapeRun run_;
  MessageFolder folder_;
  bool over_ = false;
  bool after_turn_ = false;
  bool any_in_turn_ = false;
  Nanoseconds shift_{};        ///< from log time to the stream's line
  LogTime last_on_line_{};     ///< time of the last message
  LogTime last_block_{};       ///< log time of the last restatement
  bool has_unplayed_ = false;  ///< a message was folded that is not played
  bool settling_ = false;      ///< the last restatement interrupted one of a source's own
  std::uint32_t settled_ = 0;  ///< restatements for that reason in this turn
  std::uint64_t blocks_ = 0;

  std::vector<RestatedDatagram> block_;
  std::size_t block_taken_ = 0;
  Due block_due_;
  std::optional<LogMessage> head_;
  bool head_taken_ = true;
};

}  // namespace rocinante
