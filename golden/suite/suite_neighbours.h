#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "golden/suite/suite.h"

namespace rocinante {

/// The other suites beside a suite's file that keep their goldens in its folder; files that are not
/// suites, or cannot be read, are passed over.
std::vector<Suite> neighboursOf(const Suite& suite);

enum class GoldenKind : std::uint8_t { picture, run };

/// Tells that one of them has a case, or a run, of this name and so the same goldens; empty when
/// none has.
std::string sharedGolden(const std::vector<Suite>& neighbours, GoldenKind kind,
                         std::string_view name);

/// True when a frame of the suite may have this name, whatever its log is.
bool mayHaveFrame(const Suite& suite, std::string_view name);

}  // namespace rocinante
