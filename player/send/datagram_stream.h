#pragma once

#include <cstdint>
#include <optional>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "player/send/tape_position.h"

namespace rocinante {

/// A part of a session to be played: [from, until).
struct PlayedSpan {
  LogTime from{};
  LogTime until{};
  bool operator==(const PlayedSpan&) const = default;
};

/// When a datagram is due and what it is.
struct Due {
  LogTime time{};           ///< on the stream's own line: turns of a loop lie one after the other
  std::uint32_t span = 0;   ///< which played span it belongs to, from 0
  bool restated = false;    ///< the sender's own restatement: in no count and no hash
  bool after_turn = false;  ///< its span began because the one before it was played to its end
  std::uint16_t route = 0;  ///< by which of the sender's sockets it leaves
  PlayedSpan bounds{};      ///< of its span; both 0: the stream does not say
  TapePosition place{};     ///< in the logs; of a restatement: where it is said
  bool continues = false;   ///< a restatement of which further datagrams follow
};

/// Datagrams to be sent, in order of their time: a log's messages, a CSV file's rows, a motion.
/// One thread.
class DatagramStream {
 public:
  virtual ~DatagramStream() = default;

  /// The next datagram's due time; empty at the end. Asked again before take(), the same answer.
  virtual Result<std::optional<Due>> due() = 0;

  /// Takes the datagram that due() announced. Valid until the next call of either.
  virtual ByteView take() = 0;
};

}  // namespace rocinante
