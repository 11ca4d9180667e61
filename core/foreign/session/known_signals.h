#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "core/packet/packet.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Whose signals: a device, a link of it, or (both empty) none.
using SignalOwner = std::pair<std::string, std::string>;

/// "arm", "arm/tip", or "-" for none, as packets have them but unescaped.
std::string ownerText(const SignalOwner& owner);

/// Which signals a session has, and of what kinds: for formats that declare a channel's fields
/// before its first message. Bounded, as names come from strangers.
class KnownSignals {
 public:
  static constexpr std::size_t kMost = 65'536;

  explicit KnownSignals(std::size_t most = kMost) : most_(most) {}

  struct Signal {
    SignalKind kind{};  ///< the first one
    std::string unit;   ///< the last one; empty: none was stated
    bool operator==(const Signal&) const = default;
  };
  /// By name.
  using Signals = std::map<std::string, Signal, std::less<>>;

  /// What holds at the beginning.
  void notice(const SessionState& state);
  void notice(const Packet& packet);

  const std::map<SignalOwner, Signals>& byOwner() const { return by_owner_; }
  /// Grows with each name, and with the first unit of each.
  std::uint64_t growth() const { return growth_; }
  /// What was said of further ones, which are in no owner's.
  struct Beyond {
    std::uint64_t values = 0;
    std::uint64_t units = 0;  ///< those with a unit
  };
  const Beyond& beyond() const { return beyond_; }

 private:
  void add(const SignalOwner& owner, std::string_view name, SignalKind kind, std::string_view unit);

  std::map<SignalOwner, Signals> by_owner_;
  std::size_t most_;
  std::size_t count_ = 0;
  std::uint64_t growth_ = 0;
  Beyond beyond_;
};

}  // namespace rocinante
