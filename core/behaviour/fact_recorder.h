#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/behaviour/session_track.h"
#include "core/packet/session_state.h"
#include "core/packet/state_items.h"

namespace rocinante {

/// Everything of a part of a drawing but its points: kind, colour, size, carrier, text, number of
/// points.
std::string drawingStyle(const Drawing& drawing, const std::vector<double>& part);

/// Points (x y z triples, metres) in few numbers: extents (6), mean (3), and 16 points along them
/// (48), the first and the last among them. A point between those is seen only by extents and mean.
std::vector<double> drawingShape(const std::vector<double>& points);

/// A signal whose facts may have changed; borrowed. `item` is null when nothing states it.
struct ChangedSignal {
  const std::string& device;
  const SignalName& name;
  const Item<SignalValue>* item;
};

/// Keeps the facts of a session, each change once. Each part of a drawing is a fact, since one may
/// come earlier than another: "drawing/planner/path", and with a tab, which no name has,
/// "drawing/planner/path\t2". Of a signal that is a number its unit is one: "unit of signal arm
/// load".
class FactRecorder {
 public:
  using Facts = std::map<std::string, std::vector<FactChange>, std::less<>>;

  /// Adds to `facts`, which is borrowed.
  explicit FactRecorder(Facts& facts) : facts_(facts) {}

  /// What is stated at `time`; times never decrease. What was stated before and is not any more
  /// changes to an empty text. `is_restated`: it was stated before.
  void note(const SessionState& state, LogTime time, bool is_restated);
  /// The same where nothing else has changed since the last call.
  void note(std::span<const ChangedSignal> signals, LogTime time, bool is_restated);

  /// Items and facts that were looked at so far.
  std::uint64_t looked() const { return looked_; }

 private:
  void setSignal(const SignalItem& item, LogTime time);
  /// What was stated and is not seen any more.
  void endUnseen(std::vector<FactChange>& changes, LogTime time);
  void set(const std::string& name, LogTime time, std::string text, std::vector<double> shape = {});

  Facts& facts_;
  bool is_restated_ = false;
  std::uint64_t looked_ = 0;
  std::vector<const std::vector<FactChange>*> seen_;  ///< stated by the state being noted
};

}  // namespace rocinante
