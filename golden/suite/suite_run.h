#pragma once

#include <string>
#include <vector>

#include "golden/run/run_spec.h"

namespace rocinante {

class SuiteTable;

/// A [[run]] of a suite: sessions judged as motion (docs/golden-suites.md, "Runs").
struct SuiteRun {
  std::string name;  ///< the log under test is given by `--log NAME=FILE`
  RunSpec spec;
  std::vector<std::string> tags;
  int line = 0;  ///< in the suite's file
};

/// Reads a [[run]].
SuiteRun readSuiteRun(SuiteTable& table);

}  // namespace rocinante
