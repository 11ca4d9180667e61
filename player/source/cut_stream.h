#pragma once

#include "player/send/datagram_stream.h"

namespace rocinante {

/// Another stream up to, but not including, a moment.
class CutStream final : public DatagramStream {
 public:
  /// `stream` must outlive this.
  CutStream(DatagramStream& stream, LogTime until) : stream_(stream), until_(until) {}

  Result<std::optional<Due>> due() override {
    Result<std::optional<Due>> due = stream_.due();
    if (due && *due && (*due)->time >= until_) return std::optional<Due>();
    return due;
  }
  ByteView take() override { return stream_.take(); }

 private:
  DatagramStream& stream_;
  LogTime until_;
};

}  // namespace rocinante
