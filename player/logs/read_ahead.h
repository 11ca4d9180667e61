#pragma once

#include <memory>

#include "player/send/datagram_stream.h"

namespace rocinante {

/// Reads another stream ahead in its own thread, so that neither the disk nor decompression delays
/// a deadline. Holds at most 4 MiB of payloads plus the largest one.
class ReadAhead final : public DatagramStream {
 public:
  /// `stream` must outlive this, and only the thread may use it until then. With `fill` the
  /// constructor returns when the memory is full or the stream has ended; otherwise at once, with
  /// the first datagrams ready soon.
  explicit ReadAhead(DatagramStream& stream, bool fill = true);
  ~ReadAhead() override;
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// Returns the stream's own error after everything read before it.
  Result<std::optional<Due>> due() override;
  ByteView take() override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
