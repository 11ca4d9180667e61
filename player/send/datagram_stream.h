#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/signing/signed_datagram.h"

namespace rocinante {

/// A position in several logs played as one, ordered by time, then log, then place in the file. A
/// player's position is not just a time: each of several messages of equal time can be reached.
struct TapePosition {
  LogTime time{};
  std::uint32_t log = 0;          ///< index of the argument, from 0
  std::uint64_t file_offset = 0;  ///< LogMessage::file_offset

  auto operator<=>(const TapePosition&) const = default;

  /// Before every message of `moment`.
  static constexpr TapePosition at(LogTime moment) { return {moment, 0, 0}; }
  /// Right after the message at `place`.
  static constexpr TapePosition behind(TapePosition place) {
    if (place.file_offset < std::numeric_limits<std::uint64_t>::max()) ++place.file_offset;
    return place;
  }
};

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

/// Another stream with every datagram signed when it is taken, which is when it is sent.
class SigningStream final : public DatagramStream {
 public:
  /// Both must outlive this. The stream's datagrams must be packet text.
  SigningStream(DatagramStream& stream, DatagramSigner& signer)
      : stream_(stream), signer_(signer) {}

  Result<std::optional<Due>> due() override { return stream_.due(); }
  ByteView take() override { return signer_.sign(stream_.take()); }

 private:
  DatagramStream& stream_;
  DatagramSigner& signer_;
};

}  // namespace rocinante
