#pragma once

#include <gtest/gtest.h>

#include <filesystem>

namespace rocinante::test {

/// Real data that nobody here made, in place: `../shared/data` beside the project.
inline std::filesystem::path sharedData(const std::filesystem::path& below = {}) {
  return std::filesystem::path(ROCINANTE_SHARED_DIR) / "data" / below;
}

/// Inputs from public bug reports, each folder with a README that states what is right:
/// `../shared/field` beside the project.
inline std::filesystem::path sharedField(const std::filesystem::path& below = {}) {
  return std::filesystem::path(ROCINANTE_SHARED_DIR) / "field" / below;
}

}  // namespace rocinante::test

/// First line of a test of such an input: skips with a clear line where it is absent.
#define ROCINANTE_NEEDS_SHARED_FIELD(below)                          \
  if (!std::filesystem::exists(rocinante::test::sharedField(below))) \
  GTEST_SKIP() << "no field case here: " << rocinante::test::sharedField(below).string()

/// First line of a test that reads real data: skips with a clear line where it is absent.
#define ROCINANTE_NEEDS_SHARED_DATA(below)                          \
  if (!std::filesystem::exists(rocinante::test::sharedData(below))) \
  GTEST_SKIP() << "no real data here: " << rocinante::test::sharedData(below).string()
