#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/foreign/session/session_format.h"

namespace rocinante {

/// The signals of one owner as JSON that Foxglove's Plot panel draws: numbers, booleans and
/// strings. A point in a name nests, so that the message path is the name: `j1.velocity` is
/// {"j1": {"velocity": 0.5}}, `/signals/arm.j1.velocity`. Where the part before a point is a signal
/// itself, or a part is empty, the whole name is a key: `/signals/arm."j1.velocity"`.
class SignalJson {
 public:
  SignalJson() = default;
  explicit SignalJson(const KnownSignals::Signals& signals);

  /// Whether it is of just these.
  bool isOf(const KnownSignals::Signals& signals) const;

  /// JSON schema of the messages; a unit is the field's description.
  std::string schema() const;
  /// One message. A signal that nothing states is missing; with `only_new` also those that are not
  /// new.
  std::string message(std::span<const StatedSignal> signals, bool only_new = false) const;

 private:
  struct Field {
    std::vector<std::string> keys;  ///< from the outermost
    KnownSignals::Signal signal;
  };
  std::map<std::string, Field, std::less<>> fields_;  ///< by name
};

}  // namespace rocinante
