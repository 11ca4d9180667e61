#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "golden/suite/suite.h"

namespace rocinante {

/// One picture of a case: what a golden belongs to. A case with `every`, `events` or several
/// cameras gives many.
struct SuiteFrame {
  std::string name;  ///< CASE[.CAMERA][-MOMENT], unique in its suite
  /// Borrowed from the suite. Null where there is no suite to draw from: in a report that was put
  /// together from others or compares revisions.
  const SuiteCase* suite_case = nullptr;
  std::optional<LogTime> time;  ///< empty: the moment does not exist; `why` says why
  std::string why;
  std::string case_name{};
  std::string camera{};  ///< empty: as render chooses
  std::vector<std::string> tags{};
  std::size_t place = 0;  ///< among all frames of the suite
  int line = 0;           ///< of its case in the suite's file; 0: not known
};

}  // namespace rocinante
