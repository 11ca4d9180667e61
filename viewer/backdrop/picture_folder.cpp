#include "viewer/backdrop/picture_folder.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/session/session_time.h"
#include "viewer/backdrop/video_facts.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTimesFile = "times.txt";
constexpr std::uint64_t kMaxTimesBytes = std::uint64_t{64} << 20U;

Error badFolder(std::string what, const fs::path& where) {
  return {ErrorKind::bad_argument, std::move(what), where.string()};
}

/// Removes and returns the digits at the front, without leading zeros.
std::string_view takeDigits(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && isDigit(text[end])) ++end;
  std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

Result<std::vector<Nanoseconds>> readTimes(const fs::path& file, LogTime origin, LogTime end) {
  const auto content = readFile(file, kMaxTimesBytes);
  if (!content) return content.error();
  std::vector<Nanoseconds> times;
  std::string_view text = *content;
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const std::size_t stop = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, std::min(text.substr(0, stop).find('#'), stop));
    text.remove_prefix(std::min(stop + 1, text.size()));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) continue;
    line = line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
    const auto time = parseSessionTime(line, origin, end);
    const auto here = [&] { return fmt::format("{}, line {}", file.string(), line_number); };
    if (!time) return badFolder(time.error().what, here());
    if (!times.empty() && *time - origin <= times.back()) {
      return badFolder("this time is not after the one before", here());
    }
    if (times.size() == kMostBackdropPictures) break;
    times.push_back(*time - origin);
  }
  return times;
}

Result<std::vector<fs::path>> filesOf(const fs::path& folder) {
  std::error_code fault;
  std::vector<fs::path> files;
  for (fs::directory_iterator at(folder, fault), stop; !fault && at != stop; at.increment(fault)) {
    const std::string name = at->path().filename().string();
    std::error_code ignored;
    if (name == kTimesFile || name.starts_with('.') || !at->is_regular_file(ignored)) continue;
    files.push_back(at->path());
    if (files.size() > kMostBackdropPictures) {
      return badFolder(fmt::format("the folder has more than {} files", kMostBackdropPictures),
                       folder);
    }
  }
  if (fault) return Error{ErrorKind::unreadable, fault.message(), folder.string()};
  std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
    return comesBefore(a.filename().string(), b.filename().string());
  });
  return files;
}

}  // namespace

bool comesBefore(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (isDigit(a.front()) && isDigit(b.front())) {
      const std::string_view first = takeDigits(a), second = takeDigits(b);
      if (first.size() != second.size()) return first.size() < second.size();
      if (first != second) return first < second;
      continue;
    }
    if (a.front() != b.front()) return a.front() < b.front();
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;
}

Result<PictureFolder> readPictureFolder(const fs::path& folder, Nanoseconds period, LogTime origin,
                                        LogTime end) {
  auto files = filesOf(folder);
  if (!files) return files.error();
  if (files->empty()) return badFolder("there is no picture in this folder", folder);
  PictureFolder found{std::move(*files), {}};
  const fs::path times = folder / kTimesFile;
  std::error_code ignored;
  if (period > Nanoseconds(0)) {
    for (std::size_t i = 0; i < found.files.size(); ++i) {
      found.times.push_back(static_cast<std::int64_t>(i) * period);
    }
    return found;
  }
  if (!fs::exists(times, ignored)) {
    return badFolder(
        "when its pictures were taken is unknown: give FOLDER,fps=N, or a times.txt "
        "in it, one time a line",
        folder);
  }
  auto read = readTimes(times, origin, end);
  if (!read) return read.error();
  if (read->size() != found.files.size()) {
    return badFolder(fmt::format("{} for {}", countText(read->size(), "time"),
                                 countText(found.files.size(), "picture")),
                     times);
  }
  found.times = std::move(*read);
  return found;
}

}  // namespace rocinante
