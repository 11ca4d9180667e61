#pragma once

#include <string>

#include "core/base/hash.h"
#include "core/log/log_types.h"

namespace rocinante {

/// The identity of a session (docs/log-format.md, "Identity"), fed message by message in the log's
/// order; skips messages that were not captured. Compression, keyframes, marks and attachments do
/// not change it.
class ContentHash {
 public:
  void add(const LogMessage& message);
  /// Lower-case hexadecimal; the object starts over.
  std::string finish();

 private:
  Sha256 hash_;
};

}  // namespace rocinante
