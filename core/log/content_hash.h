#pragma once

#include <string>

#include "core/base/hash.h"
#include "core/log/log_types.h"

namespace rocinante {

/// The identity of a session (docs/log-format.md, "Identity"), fed message by message in the log's
/// order; messages that are not captured are left out. Compression, keyframes, marks and
/// attachments do not change it.
class ContentHash {
 public:
  void add(const LogMessage& message);
  /// Lower-case hexadecimal; the object starts anew.
  std::string finish();

 private:
  Sha256 hash_;
};

}  // namespace rocinante
