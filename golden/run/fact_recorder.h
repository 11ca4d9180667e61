#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/packet/session_state.h"
#include "golden/run/session_track.h"

namespace rocinante {

/// Keeps the facts of a session, each change once.
class FactRecorder {
 public:
  using Facts = std::map<std::string, std::vector<FactChange>, std::less<>>;

  /// Adds to `facts`, which is borrowed.
  explicit FactRecorder(Facts& facts) : facts_(facts) {}

  /// What is stated at `time`; times never decrease. What was stated before and is not any more
  /// changes to an empty text. `is_restated`: it was stated before.
  void note(const SessionState& state, LogTime time, bool is_restated);

 private:
  void set(const std::string& name, LogTime time, std::string text, std::vector<double> shape = {});

  Facts& facts_;
  bool is_restated_ = false;
  std::vector<const std::vector<FactChange>*> seen_;  ///< stated by the state being noted
};

}  // namespace rocinante
