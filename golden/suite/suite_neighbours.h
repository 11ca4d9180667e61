#pragma once

#include <string_view>
#include <vector>

#include "golden/suite/suite.h"

namespace rocinante {

/// The other suites beside a suite's file that keep their goldens in its folder; files that are not
/// suites, or cannot be read, are passed over.
std::vector<Suite> neighboursOf(const Suite& suite);

/// True when a frame of the suite may have this name, whatever its log is.
bool mayHaveFrame(const Suite& suite, std::string_view name);

}  // namespace rocinante
