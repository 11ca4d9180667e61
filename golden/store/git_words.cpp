#include "golden/store/git_words.h"

#include <algorithm>

#include "core/base/plain_text.h"
#include "golden/store/child_output.h"

namespace rocinante {
namespace {

/// Of one file: a log of an accepted run.
constexpr std::uint64_t kMaxFileBytes = std::uint64_t{4} << 30U;

}  // namespace

std::string firstLineOf(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string complaintIn(const std::string& text) {
  for (const char* mark : {"fatal: ", "error: "}) {
    const std::size_t at = text.find(mark);
    if (at != std::string::npos) return firstLineOf(text.substr(at));
  }
  return firstLineOf(text);
}

Result<std::string> gitOutput(std::vector<std::string> line, const std::filesystem::path& place) {
  auto output = childOutput(line, kMaxFileBytes);
  if (!output.ok()) return output.error();
  if (output->exit_code == 0) return std::move(output->out);
  return Error{ErrorKind::refused, "git says: " + plainText(complaintIn(output->err)),
               place.string()};
}

Result<std::string> gitIn(const std::filesystem::path& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"git", "-C", folder.empty() ? "." : folder.string()});
  return gitOutput(std::move(words), folder);
}

std::vector<std::string> partsOf(const std::string& text, char end) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t at = std::min(text.find(end, begin), text.size());
    if (at > begin) parts.push_back(text.substr(begin, at - begin));
    begin = at + 1;
  }
  return parts;
}

}  // namespace rocinante
