#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// Accepted pictures and logs under a ref of the repository's remote (`store =
/// "git:refs/goldens"`): nothing of them is in a work tree or in a branch's history. By the git
/// program.
///
/// Beside the repository's own data, in GIT_DIR/rocinante/REF, lie `files`, which is what was
/// approved or fetched here, by name, and `objects.git`, a bare repository that has only the ref:
/// the repository itself, which may be a shallow or partial clone, is not touched. Names are hashes
/// of contents, so that a file of one name is never another one. docs/golden-suites.md, "A store".
class GitStore {
 public:
  /// refused, with git's message, when `folder` is in no repository. Asks no remote.
  static Result<GitStore> open(const std::filesystem::path& folder, const std::string& ref);

  /// The folder of files.
  std::filesystem::path files() const { return base_ / "files"; }
  const std::string& ref() const { return ref_; }

  /// True for a file that is here, or that the remote's ref has. Asks the remote at most once.
  bool has(const std::string& name) const;
  /// Brings one file from the remote unless it is here: by its hash, where the remote allows it,
  /// else with all others. not_found when the ref does not have it.
  Status bring(const std::string& name) const;

  struct Pushed {
    std::size_t added = 0, there = 0;
    int attempts = 1;
  };
  /// Adds files to the ref, all that the remote does not have yet. Others may push meanwhile: their
  /// files stay, and it is tried again. not_found when one is neither here nor there; refused when
  /// the ref is not the store's.
  Result<Pushed> push(const std::set<std::string>& names) const;

  /// The names that a manifest of goldens uses; empty for other files of that name.
  using NamesIn = std::function<Result<std::set<std::string>>(const std::string& text,
                                                              const std::string& place)>;
  struct Collected {
    std::vector<std::string> removed;
    std::size_t kept = 0, branches = 0;
  };
  /// Removes files that no branch or tag of the remote and no branch here names, and that were not
  /// pushed in the last `keep_days` (their branch may not be there yet). `dry`: only tells. refused
  /// when the ref is not the store's.
  Result<Collected> collect(const NamesIn& names_in, int keep_days, bool dry) const;

 private:
  GitStore(std::filesystem::path root, std::filesystem::path base, std::string ref,
           std::string remote)
      : root_(std::move(root)),
        base_(std::move(base)),
        ref_(std::move(ref)),
        remote_(std::move(remote)) {}

  /// Git in the bare repository; its output, or its first complaint.
  Result<std::string> git(std::vector<std::string> words) const;
  Status makeRepository() const;
  /// The commit that the remote's ref has; empty when there is none.
  Result<std::string> remoteTip() const;
  /// The same, fetched.
  Result<std::string> fetchTip(bool with_history) const;
  /// refused when somebody else made the commit, or one before it: the ref is not the store's.
  Status ownsAll(const std::string& tip, bool with_history) const;
  /// Hashes by name of the files of a commit, or of files here, which are then objects too.
  using Blobs = std::map<std::string, std::string>;
  Result<Blobs> filesOf(const std::string& commit) const;
  Result<Blobs> written(const std::set<std::string>& names) const;
  /// A tree of the commit `before` (empty: nothing) and these.
  Result<std::string> writeTree(const std::string& before, const Blobs& added) const;
  Result<std::string> commit(const std::string& tree, const std::string& parent,
                             const std::string& message) const;
  /// False when somebody else changed the ref first.
  Result<bool> pushCommit(const std::string& commit, const std::string& before, bool replace) const;
  Result<Pushed> pushOnce(const std::set<std::string>& names, bool& is_done) const;
  Result<Collected> collectOnce(const NamesIn& names_in, int keep_days, bool dry,
                                bool& is_done) const;
  Result<std::set<std::string>> namedBy(const NamesIn& names_in, std::size_t& branches) const;
  Status needRemote() const;

  std::filesystem::path root_;  ///< of the repository around the suite
  std::filesystem::path base_;
  std::string ref_;
  std::string remote_;  ///< its name; empty: the repository has none
  struct Listing {
    bool is_read = false, is_fresh = false;
    std::map<std::string, std::string> names;
  };
  std::shared_ptr<Listing> listing_ = std::make_shared<Listing>();  ///< of the ref, by has()
};

/// How often a push is tried that others are faster than.
inline constexpr int kMaxPushes = 20;
/// Waits some milliseconds by chance: two that push at once must not meet again.
void waitForOthers(int attempt);

/// "refs/goldens/files" of "git:refs/goldens", since git refuses to push a ref of one word;
/// "refs/a/b" of "git:refs/a/b". bad_argument, without a place, when it is not a ref of its own
/// below refs/ (a branch or tag would be checked out or fetched by everybody).
Result<std::string> storeRef(std::string_view store);
inline constexpr std::string_view kGitStorePrefix = "git:";

}  // namespace rocinante
