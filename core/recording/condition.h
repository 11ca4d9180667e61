#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/packet/packet.h"

namespace rocinante {

/// A condition on which a recording begins or ends, or a ring is saved: COND of
/// docs/programs/record.md, "Conditions".
struct Condition {
  enum class Kind : std::uint8_t { event, source, device, silence } kind = Kind::event;
  std::string pattern;    ///< core/base/pattern.h; for the event's text, the SOURCE or the DEVICE
  Nanoseconds silence{};  ///< the time without a datagram

  /// "event=TEXT", "source=NAME", "device=NAME", "silence=DURATION"; a text without '=' is an
  /// event's text. bad_argument for another word before the '='.
  static Result<Condition> parse(std::string_view text);
  std::string text() const;
};

/// Waits for any of several conditions. An event counts every time; a source and a device only the
/// first time; silence once each time it occurs, counted from the last datagram. Restatements by
/// other programs are ignored. Pure.
class ConditionWatch {
 public:
  explicit ConditionWatch(std::vector<Condition> conditions);

  bool any() const { return !watched_.empty(); }
  /// The condition that this datagram meets, or null. `packet` is null when it is not a packet.
  const Condition* metBy(LogTime time, const Packet* packet);
  /// The condition met because nothing arrived up to `reached`, at moment().
  const Condition* metBySilence(LogTime reached);
  /// When the last silence was met.
  LogTime moment() const { return moment_; }

 private:
  struct Watched {
    Condition condition;
    bool spent = false;
  };
  std::vector<Watched> watched_;
  bool listens_ = false;  ///< to something other than silence
  LogTime last_{};
  LogTime moment_{};
};

}  // namespace rocinante
