#pragma once

#include <memory>

#include "player/send/datagram_stream.h"

namespace rocinante {

/// Reads another stream ahead in a thread of its own, so that neither the disk nor a decompression
/// ever delays a deadline. Holds at most 4 MiB of payloads beside the largest one.
class ReadAhead final : public DatagramStream {
 public:
  /// `stream` must outlive this and is used by the thread alone until then. When `fill` is set it
  /// returns when the memory is full or the stream has ended; otherwise at once, and the first
  /// datagrams are there soon.
  explicit ReadAhead(DatagramStream& stream, bool fill = true);
  ~ReadAhead() override;
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// Fails with the stream's own error, after everything that was read before it.
  Result<std::optional<Due>> due() override;
  ByteView take() override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
