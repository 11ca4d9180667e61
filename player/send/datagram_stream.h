#pragma once

#include <cstdint>
#include <optional>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "player/send/tape_position.h"

namespace rocinante {

/// A range of a session to play: [from, until).
struct PlayedSpan {
  LogTime from{};
  LogTime until{};
  bool operator==(const PlayedSpan&) const = default;
};

/// A datagram's due time and its place in the stream.
struct Due {
  LogTime time{};           ///< on the stream's own line, where the turns of a loop are consecutive
  std::uint32_t span = 0;   ///< number of its played span, from 0
  bool restated = false;    ///< the sender's own restatement, not counted or hashed
  bool after_turn = false;  ///< its span began because the previous one was played to its end
  std::uint16_t route = 0;  ///< index of the sender's socket
  PlayedSpan bounds{};      ///< of its span; both 0: unknown
  TapePosition place{};     ///< in the logs; for a restatement, where it is sent
  bool continues = false;   ///< more datagrams of this restatement follow
};

/// Datagrams to send in time order: a log's messages, a CSV file's rows, a motion. One thread.
class DatagramStream {
 public:
  virtual ~DatagramStream() = default;

  /// The next datagram's due time; empty at the end. The same until take().
  virtual Result<std::optional<Due>> due() = 0;

  /// Takes the datagram of due(). Valid until the next call of either.
  virtual ByteView take() = 0;
};

}  // namespace rocinante
