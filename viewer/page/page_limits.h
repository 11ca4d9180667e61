#pragma once

#include <cstdint>

namespace rocinante {

/// A page is held in memory several times while it is made.
constexpr std::uint64_t kMostPageBytes = std::uint64_t{1} << 30U;
/// A page's memory ends at 2 GiB (cmake/web.cmake), and the log is in it whole. Also in served.js.
constexpr std::uint64_t kMostLogInPageBytes = 2'000'000'000;

}  // namespace rocinante
