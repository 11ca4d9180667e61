#pragma once

#include "core/copy/log_make.h"
#include "core/foreign/decode/datagram_decoders.h"
#include "core/foreign/decode/decode_account.h"

namespace rocinante {

struct DecodeReport {
  CopyReport copy;
  decode::DecodeAccount account;
};

/// Makes a log with the packets that `decoders` make of a log's octets, in place of those that
/// others made: captured messages stay as they are.
Result<DecodeReport> decodeLog(const std::filesystem::path& log, decode::DatagramDecoders& decoders,
                               const MakeOptions& make);

}  // namespace rocinante
