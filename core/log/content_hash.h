#pragma once

#include <string>

#include "core/base/hash.h"
#include "core/log/log_types.h"

namespace rocinante {

/// The identity of a session (docs/log-format.md, "Identity"), fed message by message in the log's
/// order: the captured messages, and apart from them the packets that decoders made. Compression,
/// keyframes, marks and attachments do not change it.
class ContentHash {
 public:
  void add(const LogMessage& message);
  /// Of the captured messages, in lower-case hexadecimal; starts over.
  std::string finish();
  /// Of the decoded packets; empty when there is none. Starts over.
  std::string finishDecoded();

 private:
  Sha256 captured_;
  Sha256 decoded_;
  bool any_decoded_ = false;
};

}  // namespace rocinante
