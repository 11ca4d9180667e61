#pragma once

#include <cstdint>

namespace rocinante {

/// A page is held in memory several times while it is made.
constexpr std::uint64_t kMostPageBytes = std::uint64_t{1} << 30U;

}  // namespace rocinante
