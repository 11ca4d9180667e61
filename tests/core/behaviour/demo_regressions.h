#pragma once

#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "core/behaviour/run_judge.h"
#include "tests/core/behaviour/said_session.h"

namespace rocinante::test {

inline constexpr double kDegree = std::numbers::pi / 180;

/// A deliberate change of a session, and how the judge must name it.
struct Regression {
  const char* what;
  RunFinding::Kind kind;
  const char* item;
  double from_s, until_s;  ///< where the judge must see it begin, in the accepted session
  std::function<void(SaidSession&)> change;
  const char* said = "";  ///< in the sentence
  RunAlign align = RunAlign::events;
};

std::function<double(double, double)> plus(double by);

/// What a joint of a device had a time ago, for as long as the change lasts.
void delay(SaidSession& session, const std::string& device, std::size_t number, double by_s,
           double from = 0, double until = 1e9);

/// Of the demo's session.
std::vector<Regression> demoRegressions();

}  // namespace rocinante::test
