#include "golden/compare/cdash_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/base/plain_text.h"

namespace rocinante {

bool isUnderDashboard() {
  const char* const value = std::getenv("DASHBOARD_TEST_FROM_CTEST");
  return value != nullptr && *value != '\0';
}

std::string cdashPicture(std::string_view role, const std::filesystem::path& png) {
  std::error_code fault;
  const std::string path = std::filesystem::absolute(png, fault).lexically_normal().string();
  // CTest reads the path as it is, up to the next tag.
  const bool fits = !fault && std::ranges::none_of(path, [](char c) {
    return c == '<' || c == '>' || static_cast<unsigned char>(c) < 0x20;
  });
  if (!fits) return {};
  return fmt::format(
      "<DartMeasurementFile name=\"{}\" type=\"image/png\">{}</DartMeasurementFile>\n",
      xmlText(role), path);
}

}  // namespace rocinante
