#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rocinante {

/// True inside a test of a dashboard's build (`ctest -D Experimental`): CTest then sets
/// DASHBOARD_TEST_FROM_CTEST and takes the lines of cdashPicture() out of what a test prints.
bool isUnderDashboard();

/// A line by which CTest uploads a picture with the test's result: CDash shows TestImage,
/// ValidImage and DifferenceImage2 of one test over one another. The file must exist until the
/// tests have ended; a path that no such line can hold gives an empty text.
std::string cdashPicture(std::string_view role, const std::filesystem::path& png);

inline constexpr std::string_view kCdashFrame = "TestImage";
inline constexpr std::string_view kCdashGolden = "ValidImage";
inline constexpr std::string_view kCdashDifference = "DifferenceImage2";

}  // namespace rocinante
