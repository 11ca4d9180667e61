#pragma once

#include <cstdint>

#include "core/mcap/byte_sink.h"

namespace rocinante {

/// Room on the disk behind what is written, allocated ahead in steps, so that a log can always be
/// brought to its end. docs/log-format.md, "A disk that refuses".
class TailReserve {
 public:
  /// Sees to it that the file can grow to `end_bytes`. Fails when the disk has no room for that;
  /// what was reserved before stays so.
  Status cover(ByteSink& sink, std::uint64_t end_bytes);
  /// After something was taken back from the file: nothing counts as reserved.
  void forget() { ready_until_ = 0; }

 private:
  std::uint64_t ready_until_ = 0;
};

}  // namespace rocinante
