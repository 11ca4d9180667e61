#include "golden/command/git_revision.h"

#include <fmt/format.h>

#include <set>

#include "core/base/plain_text.h"
#include "golden/store/child_output.h"

namespace rocinante {
namespace {

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

Result<std::string> git(const std::filesystem::path& folder, std::vector<std::string> words) {
  std::vector<std::string> line{"git", "-C", folder.string()};
  line.insert(line.end(), words.begin(), words.end());
  auto output = childOutput(line);
  if (!output.ok()) return output.error();
  if (output->exit_code == 0) return std::move(output->out);
  return Error{ErrorKind::refused, "git says: " + plainText(firstLine(output->err)),
               folder.string()};
}

void addEnding(const std::string& listed, std::string_view ending,
               std::set<std::filesystem::path>& found) {
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = listed.find('\0', begin)) != std::string::npos;
       begin = end + 1) {
    const std::string_view path = std::string_view(listed).substr(begin, end - begin);
    if (path.ends_with(ending)) found.emplace(path);
  }
}

}  // namespace

Result<GitRevision> GitRevision::open(const std::filesystem::path& folder,
                                      const std::string& revision) {
  const std::filesystem::path around = folder.empty() ? "." : folder;
  const auto root = git(around, {"rev-parse", "--show-toplevel"});
  if (!root.ok()) return root.error();
  const auto commit =
      git(around, {"rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}"});
  if (!commit.ok()) {
    return Error{ErrorKind::refused,
                 fmt::format("`{}` is not a commit of this repository", plainText(revision)),
                 firstLine(*root)};
  }
  return GitRevision(firstLine(*root), firstLine(*commit));
}

Result<std::string> GitRevision::file(const std::filesystem::path& file) const {
  std::error_code fault;
  const auto whole = std::filesystem::weakly_canonical(file, fault);
  const auto below = whole.lexically_relative(std::filesystem::weakly_canonical(root_, fault));
  if (fault || below.empty() || *below.begin() == "..") {
    return Error{ErrorKind::refused, "is outside the repository", file.string()};
  }
  const auto output = childOutput({"git", "-C", root_.string(), "cat-file", "--filters",
                                   commit_ + ":" + below.generic_string()});
  if (!output.ok()) return output.error();
  if (output->exit_code == 0) return output->out;
  return Error{ErrorKind::not_found,
               fmt::format("commit {} does not have this file", commit_.substr(0, 12)),
               file.string()};
}

Result<std::vector<std::filesystem::path>> GitRevision::filesThatEndWith(
    std::string_view ending) const {
  std::set<std::filesystem::path> found;
  const auto then = git(root_, {"ls-tree", "-r", "-z", "--name-only", "--full-tree", commit_});
  if (!then.ok()) return then.error();
  addEnding(*then, ending, found);
  const auto now = git(root_, {"ls-files", "-z", "--cached", "--others", "--exclude-standard"});
  if (!now.ok()) return now.error();
  addEnding(*now, ending, found);
  return std::vector<std::filesystem::path>(found.begin(), found.end());
}

}  // namespace rocinante
