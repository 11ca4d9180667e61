#pragma once

#include <gmock/gmock.h>

#include <ostream>
#include <string>
#include <utility>

#include "golden/compare/golden_check.h"

// A GoogleTest matcher for pictures (docs/goldens-in-your-tests.md):
//
//   EXPECT_THAT(frame, rocinante::MatchesGolden("gripper-open"));
//
// `frame` is a rocinante::Picture, a rocinante::PictureView, or any type with a function
// `rocinante::PictureView viewOf(const Frame&)` in its namespace. The golden folder is the macro
// ROCINANTE_GOLDEN_DIR or the environment variable of that name. Not part of the library: including
// this requires GTest::gmock.

namespace rocinante {

#ifdef ROCINANTE_GOLDEN_DIR
inline constexpr const char* kCompiledGoldenFolder = ROCINANTE_GOLDEN_DIR;
#else
inline constexpr const char* kCompiledGoldenFolder = nullptr;
#endif

class GoldenMatcher {
 public:
  using is_gtest_matcher = void;

  GoldenMatcher(std::string name, Tolerance tolerance)
      : name_(std::move(name)), tolerance_(std::move(tolerance)) {}

  template <class Frame>
  bool MatchAndExplain(const Frame& frame, std::ostream* out) const {
    GoldenAnswer answer;
    const Result<GoldenPlace> place = GoldenPlace::fromEnvironment(kCompiledGoldenFolder);
    if (place.ok()) {
      answer = checkGolden(viewOf(frame), name_, tolerance_, *place);
    } else {
      answer.text = place.error().text();
    }
    if (out != nullptr) *out << answer.text;
    return answer.passes;
  }

  void DescribeTo(std::ostream* out) const {
    *out << "matches golden \"" << name_ << "\" (" << tolerance_.name << ")";
  }
  void DescribeNegationTo(std::ostream* out) const {
    *out << "does not match golden \"" << name_ << "\" (" << tolerance_.name << ")";
  }

 private:
  std::string name_;
  Tolerance tolerance_;
};

inline GoldenMatcher MatchesGolden(std::string name, Tolerance tolerance = Tolerance::exactly()) {
  return {std::move(name), std::move(tolerance)};
}

}  // namespace rocinante
