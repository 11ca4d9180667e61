#pragma once

#include <cstdint>
#include <optional>

#include "core/bytes.h"
#include "core/result.h"
#include "core/time.h"

namespace rocinante {

/// When a datagram is due and what it is.
struct Due {
  LogTime time{};
  std::uint32_t span = 0;  ///< which played span it belongs to, from 0
  bool restated = false;   ///< the sender's own restatement: in no count and no hash
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
