#include "core/recording/record_path.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <string>
#include <system_error>

namespace rocinante {
namespace {

Result<std::string> filled(std::string_view pattern, WallTime start, std::uint64_t number) {
  const std::time_t seconds =
      std::chrono::floor<std::chrono::seconds>(start).time_since_epoch().count();
  const std::tm utc = fmt::gmtime(seconds);
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '%') {
      text += pattern[i];
      continue;
    }
    const char letter = ++i < pattern.size() ? pattern[i] : '\0';
    switch (letter) {
      case 'Y':
        text += fmt::format("{:04}", utc.tm_year + 1900);
        break;
      case 'm':
        text += fmt::format("{:02}", utc.tm_mon + 1);
        break;
      case 'd':
        text += fmt::format("{:02}", utc.tm_mday);
        break;
      case 'H':
        text += fmt::format("{:02}", utc.tm_hour);
        break;
      case 'M':
        text += fmt::format("{:02}", utc.tm_min);
        break;
      case 'S':
        text += fmt::format("{:02}", utc.tm_sec);
        break;
      case 'j':
        text += fmt::format("{:03}", utc.tm_yday + 1);
        break;
      case 'F':
        text += fmt::format("{:04}-{:02}-{:02}", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday);
        break;
      case 's':
        text += fmt::format("{}", seconds);
        break;
      case 'n':
        text += fmt::format("{:03}", number);
        break;
      case '%':
        text += '%';
        break;
      default:
        return Error{ErrorKind::bad_argument,
                     "a log's name takes %Y %m %d %H %M %S %j %F %s %n, and %% for a percent sign",
                     std::string(pattern)};
    }
  }
  return text;
}

bool isFolder(const std::filesystem::path& path) {
  std::error_code ignored;
  return path.filename().empty() || std::filesystem::is_directory(path, ignored);
}

}  // namespace

Result<std::filesystem::path> recordPath(std::string_view output, WallTime start,
                                         std::uint64_t number) {
  const Result<std::string> text =
      filled(output.empty() ? kDefaultRecordName : output, start, number);
  if (!text) return text.error();
  const std::filesystem::path path = *text;
  if (!isFolder(path)) return path;
  const Result<std::string> name = filled(kDefaultRecordName, start, number);
  if (!name) return name.error();
  return path / *name;
}

ChangingName changingName(std::string_view output) {
  ChangingName name;
  // A folder gets the default name.
  const Result<std::string> text = filled(output, WallTime{}, 1);
  name.time = output.empty() || (text && isFolder(*text));
  for (std::size_t i = 0; i + 1 < output.size(); ++i) {
    if (output[i] != '%') continue;
    ++i;
    name.number = name.number || output[i] == 'n';
    name.time = name.time || (output[i] != 'n' && output[i] != '%');
  }
  return name;
}

std::filesystem::path numberedPath(const std::filesystem::path& path, std::uint64_t number) {
  return path.parent_path() /
         fmt::format("{}-{:03}{}", path.stem().string(), number, path.extension().string());
}

}  // namespace rocinante
