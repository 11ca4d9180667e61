#pragma once

#include <gtest/gtest.h>

#include <filesystem>

namespace rocinante::test {

/// Real data that nobody here made, in place: `../shared/data` beside the project.
inline std::filesystem::path sharedData(const std::filesystem::path& below = {}) {
  return std::filesystem::path(ROCINANTE_SHARED_DIR) / "data" / below;
}

}  // namespace rocinante::test

/// First line of a test that reads real data: skips with a clear line where it is absent.
#define ROCINANTE_NEEDS_SHARED_DATA(below)                          \
  if (!std::filesystem::exists(rocinante::test::sharedData(below))) \
  GTEST_SKIP() << "no real data here: " << rocinante::test::sharedData(below).string()
