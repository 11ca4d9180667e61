#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/log/log_types.h"
#include "core/packet/decoder.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Folds a log's messages into a state, decoding each by its encoding. One thread.
class MessageFolder {
 public:
  struct Folded {
    bool applied = false;  ///< false: it cannot be decoded, or it came late
    bool is_part = false;  ///< of a restatement
  };
  /// Events are dropped: a player never restates them.
  Folded fold(SessionState& state, const LogMessage& message);

 private:
  std::map<std::string, std::unique_ptr<Decoder>, std::less<>> decoders_;
};

}  // namespace rocinante
