#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// The files of one commit of the git repository around a folder. Runs git; nothing is written.
class GitRevision {
 public:
  /// not_found when git is missing; refused, with git's message, when `folder` is not in a
  /// repository or `revision` is not a commit. A revision that begins with `-` is refused.
  static Result<GitRevision> open(const std::filesystem::path& folder, const std::string& revision);

  /// The commit's full hash.
  const std::string& commit() const { return commit_; }
  /// The repository's outermost folder.
  const std::filesystem::path& root() const { return root_; }
  /// Content of `file` in the commit, as a checkout would write it (Git LFS files are fetched by
  /// their filter). not_found when the commit does not have it; refused outside the repository.
  Result<std::string> file(const std::filesystem::path& file) const;
  /// Files whose names end with `ending` in any folder, of the commit or of the working tree now,
  /// below the root, sorted.
  Result<std::vector<std::filesystem::path>> filesThatEndWith(std::string_view ending) const;

 private:
  GitRevision(std::filesystem::path root, std::string commit)
      : root_(std::move(root)), commit_(std::move(commit)) {}

  std::filesystem::path root_;
  std::string commit_;
};

}  // namespace rocinante
