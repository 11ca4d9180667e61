#pragma once

#include <optional>

#include "core/cell/cell.h"
#include "core/check/check.h"
#include "core/foreign/decode/datagram_decoders.h"
#include "core/foreign/decode/decode_account.h"
#include "core/log/log_reader.h"

namespace rocinante {

/// Decodes the octets of a log that nobody has decoded yet, while it is judged. One thread.
class LogOctets {
 public:
  /// By the decoders of `file`, else by those that the cell names, which are read only when the log
  /// has such octets.
  static Result<LogOctets> of(const LogReader& log, const std::string& file, const Cell& cell);

  explicit operator bool() const { return decoders_.has_value(); }
  /// See OctetPackets.
  DecodedOctets packetOf(const LogMessage& message, bool has_packet);
  decode::DecodeAccount account() const { return decode::accountOf(*decoders_, octets_); }

 private:
  std::optional<decode::DatagramDecoders> decoders_;
  /// Of octets that have their packets: their account is that of who made them.
  std::optional<decode::DatagramDecoders> again_;
  std::uint64_t octets_ = 0;
};

}  // namespace rocinante
