#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/log/log_types.h"
#include "core/packet/session_state.h"

namespace rocinante {

class Decoder;

/// The payload of a keyframe: the whole state said again as packets, an empty line between two
/// (docs/log-format.md, "Keyframes"). Empty for a state that knows no source. What it says is exact
/// only where no restatement is unfinished.
std::string keyframeText(const SessionState& state);

/// The datagrams of a keyframe one after another, borrowed from `payload`: ordinary packet text.
std::vector<std::string_view> keyframeDatagrams(ByteView payload);

/// True for the channels whose messages are keyframes.
bool isKeyframeChannel(const LogChannel& channel);

/// A keyframe that is passed over, and why.
struct KeyframeFault {
  LogTime time{};
  std::string cause;
};

/// Reads keyframes back. Holds scratch memory: one a thread.
class KeyframeReader {
 public:
  KeyframeReader();
  ~KeyframeReader();
  KeyframeReader(KeyframeReader&&) noexcept;
  KeyframeReader& operator=(KeyframeReader&&) noexcept;

  /// The state that a keyframe at `moment` tells: sameAs() that which it was made of. damaged, with
  /// the first reason, when it is not what keyframeText() could have written, but for statements
  /// and header words of a later version, which are skipped. `where` is empty: the caller knows.
  Result<SessionState> read(ByteView payload, LogTime moment);

 private:
  std::unique_ptr<Decoder> decoder_;
};

}  // namespace rocinante
