#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/rules/check_report.h"
#include "core/foreign/decode/decode_account.h"
#include "core/foreign/decode/decoder_set.h"

namespace rocinante {

struct LiveCheckOptions {
  std::vector<std::string> endpoints;
  std::string trust_file;  ///< if any: only datagrams that it trusts are judged
  /// Make packets of what is not packet text; null for none.
  std::shared_ptr<const decode::DecoderSet> decoders;
  Nanoseconds duration{};
};

/// Judges the datagrams received at all endpoints together. A stop signal ends it early, and the
/// report says that it was interrupted. Prints on standard error the bound endpoints, what was not
/// trusted, what the decoders made, and at the end those of several endpoints at which nothing
/// arrived.
Result<CheckReport> checkLive(const Cell& cell, const LiveCheckOptions& options);

/// What became of the datagrams that decoders were given, on standard error; values of them that
/// lines could not use are a finding, too.
void tellDecoded(const decode::DecodeAccount& decoded, CheckReport& report);

}  // namespace rocinante
