#pragma once

#include <cstddef>
#include <cstdlib>

namespace rocinante::test {

/// How far a test that breaks a file place by place goes to the next one: 1 in release, where each
/// answer is judged. The sanitizers, under which reading takes ten times as long, see every seventh
/// byte, unless ROCINANTE_EVERY_PLACE is set (scripts/nightly tests).
inline std::size_t nextPlace() {
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
  if (std::getenv("ROCINANTE_EVERY_PLACE") == nullptr) return 7;
#endif
#endif
  return 1;
}

}  // namespace rocinante::test
