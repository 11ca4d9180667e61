#include "golden/approval/approval_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kHashDigits = 32;

std::string_view trimmed(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

bool isPixelHash(std::string_view text) {
  return text.size() == kHashDigits &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

Result<ApprovalList> parseApprovalList(std::string_view text, const std::string& file) {
  ApprovalList list;
  int number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.starts_with('#')) continue;
    const auto wrong = [&](std::string what) {
      return Error{ErrorKind::bad_argument, std::move(what), fmt::format("{}:{}", file, number)};
    };
    const std::size_t gap = line.find_first_of(" \t");
    const std::string_view name = line.substr(0, gap);
    const std::string_view hash = gap == line.npos ? "" : trimmed(line.substr(gap));
    if (!isPixelHash(hash)) {
      return wrong(fmt::format("`{}` is not a frame name and a pixel hash of 32 digits",
                               plainText(line.substr(0, 120))));
    }
    if (!list.emplace(name, hash).second) {
      return wrong(fmt::format("the list has frame {} twice", plainText(name)));
    }
  }
  if (list.empty()) {
    return Error{ErrorKind::bad_argument, "the list has no frames, so nothing would be approved",
                 file};
  }
  return list;
}

std::string approvalListText(const ApprovalList& list) {
  std::string text;
  for (const auto& [name, pixels] : list) text += fmt::format("{}\t{}\n", name, pixels);
  return text;
}

}  // namespace rocinante
