#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "golden/suite/suite.h"

namespace rocinante {

/// One picture of a case, the unit that has a golden. A case with `every`, `events` or several
/// cameras has many.
struct SuiteFrame {
  std::string name;  ///< CASE[.CAMERA][-MOMENT], unique in its suite
  /// Borrowed from the suite. Null in reports without a suite: merged ones and comparisons of
  /// revisions.
  const SuiteCase* suite_case = nullptr;
  std::optional<LogTime> time;  ///< empty: no such moment, explained by `why`
  std::string why;
  std::string case_name{};
  std::string camera{};  ///< empty: as render chooses
  std::vector<std::string> tags{};
  std::size_t place = 0;  ///< index among all frames of the suite
  int line = 0;           ///< of its case in the suite's file; 0: unknown
};

}  // namespace rocinante
