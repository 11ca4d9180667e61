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

/// The payload of a keyframe: the whole state restated as packets, separated by empty lines
/// (docs/log-format.md, "Keyframes"). Empty for a state without sources. Exact only while no
/// restatement is unfinished.
std::string keyframeText(const SessionState& state);

/// The datagrams of a keyframe one after another, borrowed from `payload`: ordinary packet text.
std::vector<std::string_view> keyframeDatagrams(ByteView payload);

/// True for the channels whose messages are keyframes.
bool isKeyframeChannel(const LogChannel& channel);

/// A keyframe that is skipped, and why.
struct KeyframeFault {
  LogTime time{};
  std::string cause;
};

/// Reads keyframes. Holds scratch memory: one per thread.
class KeyframeReader {
 public:
  KeyframeReader();
  ~KeyframeReader();
  KeyframeReader(KeyframeReader&&) noexcept;
  KeyframeReader& operator=(KeyframeReader&&) noexcept;

  /// The state of a keyframe at `moment`: sameAs() the state it was made from. damaged, with the
  /// first reason, when keyframeText() could not have written it, except for statements and header
  /// words of a later version, which are skipped. `where` is empty: the caller knows it.
  Result<SessionState> read(ByteView payload, LogTime moment);

 private:
  std::unique_ptr<Decoder> decoder_;
};

}  // namespace rocinante
