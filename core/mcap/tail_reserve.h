#pragma once

#include <cstdint>

#include "core/mcap/byte_sink.h"

namespace rocinante {

/// Disk space behind the written bytes, allocated ahead in steps, so that a log can always be
/// closed properly. docs/log-format.md, "A disk that refuses".
class TailReserve {
 public:
  /// Ensures that the file can grow to `end_bytes`. Fails when the disk has no room for that; what
  /// was reserved before stays reserved.
  Status cover(ByteSink& sink, std::uint64_t end_bytes);
  /// To be called after a truncation: nothing counts as reserved.
  void forget() { ready_until_ = 0; }

 private:
  std::uint64_t ready_until_ = 0;
};

}  // namespace rocinante
