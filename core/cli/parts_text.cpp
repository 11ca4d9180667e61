#include "core/cli/parts_text.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "core/base/loaded_module.h"

namespace rocinante {
namespace {

bool isThere(std::string_view file, const std::filesystem::path& programs) {
  if (file.ends_with(".so")) return !findModule(std::string(file)).empty();
  std::error_code error;
  return file.empty() || std::filesystem::exists(programs / file, error);
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

}  // namespace

std::string partsText(const std::filesystem::path& programs) {
  std::string text;
  for (const BuildPart& part : std::span(kBuildParts, kBuildPartCount)) {
    const bool there = part.built && isThere(part.file, programs);
    std::string_view state = part.built ? "absent" : "off";
    if (there) state = "on";
    std::string detail = part.detail;
    if (part.built && !there) detail = std::string(part.file) + " is not installed here";
    text += "  " + padded(part.name, 12) + padded(std::string(state), 7) +
            (detail.empty() ? part.does : std::string(part.does) + ": " + detail) + "\n";
  }
  return text;
}

}  // namespace rocinante
