#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/packet/packet.h"

namespace rocinante {

/// What a recording begins on, ends on, or what makes a ring be kept: COND of
/// docs/programs/record.md, "Conditions".
struct Condition {
  enum class Kind : std::uint8_t { event, source, device, silence } kind = Kind::event;
  std::string pattern;    ///< glob(7) for the event's text, the SOURCE or the DEVICE
  Nanoseconds silence{};  ///< that nothing came for

  /// "event=TEXT", "source=NAME", "device=NAME", "silence=DURATION"; without one of these before a
  /// '=', the whole is an event's text.
  static Result<Condition> parse(std::string_view text);
  std::string text() const;
};

/// Waits for any of several conditions. Events count each time; a source and a device the first
/// time alone; silence once each time that it falls, counted from the last datagram. What somebody
/// else restates meets nothing. Pure.
class ConditionWatch {
 public:
  explicit ConditionWatch(std::vector<Condition> conditions);

  bool any() const { return !watched_.empty(); }
  /// The condition that this datagram meets, or null. `packet` is null when it is none.
  const Condition* metBy(LogTime time, const Packet* packet);
  /// That which is met because nothing came up to `reached`; at its moment().
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
