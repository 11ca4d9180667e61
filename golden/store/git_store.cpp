#include "golden/store/git_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>

#include "core/base/atomic_file.h"
#include "core/base/plain_text.h"
#include "core/base/random_id.h"
#include "golden/store/child_output.h"
#include "golden/store/folder_lock.h"
#include "golden/store/git_words.h"

namespace rocinante {
namespace {

/// Words of one command line.
constexpr std::size_t kMaxWords = 1000;

/// The last line of each commit's message: what the store owns.
constexpr std::string_view kStoreMark = "Rocinante-Store: 1";

/// Whether the store made a commit, by its message: it has the mark, or it is of a time before the
/// mark.
bool isOwnMessage(const std::string& message) {
  const std::vector<std::string> lines = partsOf(message, '\n');
  if (lines.empty()) return false;
  if (lines.back() == kStoreMark) return true;
  for (const std::string_view subject : {"golden push: ", "golden gc: "}) {
    const std::string count = lines[0].starts_with(subject) ? lines[0].substr(subject.size()) : "";
    if (!count.empty() && count.find_first_not_of("0123456789") == count.npos) return true;
  }
  return lines[0] == "goldens";
}

/// `origin`, else the only one; empty when there is none, or a choice.
std::string remoteOf(const std::string& remotes) {
  const std::vector<std::string> names = partsOf(remotes, '\n');
  if (std::ranges::find(names, "origin") != names.end()) return "origin";
  return names.size() == 1 ? names.front() : std::string();
}

}  // namespace

Result<std::string> storeRef(std::string_view store) {
  std::string ref(store.substr(std::min(store.size(), kGitStorePrefix.size())));
  // git refuses to push a ref of one word.
  if (std::ranges::count(ref, '/') == 1) ref += "/files";
  const bool is_plain =
      ref.starts_with("refs/") && ref.size() > 5 && ref.size() <= 200 && !ref.ends_with('/') &&
      !ref.ends_with(".lock") && ref.find("..") == ref.npos && ref.find("//") == ref.npos &&
      ref.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./") ==
          ref.npos;
  if (!is_plain) {
    return Error{
        ErrorKind::bad_argument, "a store in git is `git:refs/NAME`, as git:refs/goldens", {}};
  }
  for (const char* taken : {"refs/heads/", "refs/tags/", "refs/remotes/"}) {
    if (!ref.starts_with(taken)) continue;
    return Error{ErrorKind::bad_argument,
                 "a store in git is a ref of its own, as git:refs/goldens, and no branch or tag",
                 {}};
  }
  return ref;
}

Result<GitStore> GitStore::open(const std::filesystem::path& folder, const std::string& ref) {
  const auto paths =
      gitIn(folder, {"rev-parse", "--path-format=absolute", "--show-toplevel", "--git-common-dir"});
  if (!paths.ok()) return paths.error();
  const std::vector<std::string> lines = partsOf(*paths, '\n');
  if (lines.size() != 2) {
    return Error{ErrorKind::refused, "no git repository with a work tree", folder.string()};
  }
  const auto remotes = gitIn(folder, {"remote"});
  if (!remotes.ok()) return remotes.error();
  std::string name = ref;
  std::ranges::replace(name, '/', '_');
  return GitStore(lines[0], std::filesystem::path(lines[1]) / "rocinante" / name, ref,
                  remoteOf(*remotes));
}

Result<std::string> GitStore::git(std::vector<std::string> words) const {
  // In the root, since addresses of remotes may be paths relative to it.
  words.insert(words.begin(), {"git", "-C", root_.string(), "--git-dir",
                               (base_ / "objects.git").string(), "-c", "core.bare=true"});
  return gitOutput(std::move(words), root_);
}

void waitForOthers(int attempt) {
  const auto most_ms = static_cast<std::uint64_t>(std::min(2000, 50 << std::min(attempt, 6)));
  std::this_thread::sleep_for(std::chrono::milliseconds(10 + randomNumber() % (most_ms - 9)));
}

Status GitStore::needRemote() const {
  if (!remote_.empty()) return {};
  return Error{ErrorKind::refused,
               "the repository has no remote `origin`, nor a single other one, to keep goldens",
               root_.string()};
}

Status GitStore::makeRepository() const {
  std::error_code fault;
  std::filesystem::create_directories(files(), fault);
  if (fault) {
    return Error{ErrorKind::unreadable, "cannot create: " + fault.message(), files().string()};
  }
  const std::filesystem::path made = base_ / "objects.git";
  if (std::filesystem::exists(made / "HEAD", fault)) return {};
  const auto init = gitOutput({"git", "init", "--quiet", "--bare", made.string()}, made);
  if (!init.ok()) return init.error();
  // Remotes and how to reach them are those of the repository, also when they change.
  const auto config = gitIn(root_, {"rev-parse", "--path-format=absolute", "--git-path", "config"});
  if (!config.ok()) return config.error();
  const auto included = gitOutput(
      {"git", "--git-dir", made.string(), "config", "include.path", firstLineOf(*config)}, made);
  return included.ok() ? Status() : Status(included.error());
}

Result<std::string> GitStore::remoteTip() const {
  const auto listed = git({"ls-remote", "--quiet", remote_, ref_});
  if (!listed.ok()) return listed.error();
  // "HASH\tREF"; a pattern also finds refs that end in it.
  std::string tip;
  for (const std::string& line : partsOf(*listed, '\n')) {
    if (line.ends_with("\t" + ref_)) tip = line.substr(0, line.find('\t'));
  }
  return tip;
}

Result<std::string> GitStore::fetchTip(bool with_history) const {
  if (Status has = needRemote(); !has) return has.error();
  if (Status made = makeRepository(); !made) return made.error();
  const auto listed = remoteTip();
  if (!listed.ok()) return listed;
  const std::string& tip = *listed;
  if (tip.empty()) return tip;
  const auto known = git({"rev-parse", "--quiet", "--verify", ref_});
  if (known.ok() && firstLineOf(*known) == tip && !with_history) return tip;
  std::vector<std::string> words{"fetch", "--quiet", "--no-tags",
                                 "--refmap=", "--filter=blob:none"};
  const bool is_shallow = std::filesystem::exists(base_ / "objects.git" / "shallow");
  if (!with_history) words.push_back("--depth=1");
  if (with_history && is_shallow) words.push_back("--unshallow");
  words.insert(words.end(), {remote_, "+" + ref_ + ":" + ref_});
  const auto fetched = git(std::move(words));
  if (!fetched.ok()) return fetched.error();
  const auto now = git({"rev-parse", "--verify", ref_});
  if (!now.ok()) return now.error();
  return firstLineOf(*now);
}

Status GitStore::ownsAll(const std::string& tip, bool with_history) const {
  if (tip.empty()) return {};
  std::vector<std::string> words{"log", "-z", "--format=%h%n%B"};
  if (!with_history) words.push_back("--max-count=1");
  words.push_back(tip);
  const auto commits = git(std::move(words));
  if (!commits.ok()) return commits.error();
  for (const std::string& each : partsOf(*commits, '\0')) {
    const std::size_t line = std::min(each.find('\n'), each.size());
    if (isOwnMessage(each.substr(line))) continue;
    return Error{ErrorKind::refused,
                 fmt::format("{} of {} holds something else than goldens: `golden push` did not "
                             "make its commit {}; name a ref of its own, as git:refs/goldens",
                             ref_, remote_, each.substr(0, line)),
                 root_.string()};
  }
  return {};
}

Result<GitStore::Blobs> GitStore::filesOf(const std::string& commit) const {
  Blobs blobs;
  if (commit.empty()) return blobs;
  const auto listed = git({"ls-tree", "-z", commit});
  if (!listed.ok()) return listed.error();
  for (const std::string& entry : partsOf(*listed, '\0')) {
    // "100644 blob HASH\tNAME"
    const std::size_t tab = entry.find('\t');
    const std::size_t hash = entry.rfind(' ', tab) + 1;
    if (tab != entry.npos) blobs[entry.substr(tab + 1)] = entry.substr(hash, tab - hash);
  }
  return blobs;
}

bool GitStore::has(const std::string& name) const {
  std::error_code ignored;
  if (std::filesystem::exists(files() / name, ignored)) return true;
  if (!makeRepository()) return false;
  if (!listing_->is_read) {
    listing_->is_read = true;
    if (auto names = filesOf(ref_); names.ok()) listing_->names = std::move(*names);
  }
  if (listing_->names.contains(name) || listing_->is_fresh) return listing_->names.contains(name);
  listing_->is_fresh = true;
  const auto lock = FolderLock::take(base_);
  const auto tip = lock.ok() ? fetchTip(false) : lock.error();
  if (!tip.ok() || tip->empty()) return false;
  if (auto names = filesOf(*tip); names.ok()) listing_->names = std::move(*names);
  return listing_->names.contains(name);
}

Status GitStore::bring(const std::string& name) const {
  std::error_code ignored;
  const std::filesystem::path file = files() / name;
  if (std::filesystem::exists(file, ignored)) return {};
  if (Status made = makeRepository(); !made) return made;
  // Drawing processes of one run share the bare repository.
  const auto lock = FolderLock::take(base_);
  if (!lock.ok()) return lock.error();
  if (std::filesystem::exists(file, ignored)) return {};
  const std::string object = ref_ + ":" + name;
  if (!git({"rev-parse", "--quiet", "--verify", object}).ok()) {
    const auto tip = fetchTip(false);
    if (!tip.ok()) return tip.error();
    if (tip->empty() || !git({"rev-parse", "--quiet", "--verify", object}).ok()) {
      return Error{ErrorKind::not_found,
                   fmt::format("{} of {} does not have {}; `rocinante golden push` puts there what "
                               "was approved",
                               ref_, remote_, name),
                   root_.string()};
    }
  }
  // Of a clone without contents, git fetches this one by its hash.
  const auto content = git({"cat-file", "blob", object});
  if (!content.ok()) return content.error();
  return writeFileWhole(file, bytesOf(*content), true);
}

Result<GitStore::Blobs> GitStore::written(const std::set<std::string>& names) const {
  Blobs blobs;
  for (auto name = names.begin(); name != names.end();) {
    std::vector<std::string> words{"hash-object", "-w", "--no-filters", "--"};
    const auto first = name;
    for (; name != names.end() && words.size() < kMaxWords; ++name) {
      words.push_back((files() / *name).string());
    }
    const auto hashes = git(std::move(words));
    if (!hashes.ok()) return hashes.error();
    auto next = first;
    for (std::string& hash : partsOf(*hashes, '\n')) {
      if (next != name) blobs[*next++] = std::move(hash);
    }
  }
  return blobs;
}

Result<std::string> GitStore::writeTree(const std::string& before, const Blobs& added) const {
  const auto read = before.empty() ? git({"read-tree", "--empty"}) : git({"read-tree", before});
  if (!read.ok()) return read.error();
  for (auto blob = added.begin(); blob != added.end();) {
    std::vector<std::string> words{"update-index", "--add"};
    for (; blob != added.end() && words.size() < kMaxWords; ++blob) {
      words.push_back("--cacheinfo");
      words.push_back(fmt::format("100644,{},{}", blob->second, blob->first));
    }
    const auto updated = git(std::move(words));
    if (!updated.ok()) return updated.error();
  }
  // Contents that were not fetched are not looked at.
  const auto tree = git({"write-tree", "--missing-ok"});
  if (!tree.ok()) return tree.error();
  return firstLineOf(*tree);
}

Result<std::string> GitStore::commit(const std::string& tree, const std::string& parent,
                                     const std::string& message) const {
  std::vector<std::string> words{"-c",          "user.name=rocinante",
                                 "-c",          "user.email=rocinante@invalid",
                                 "commit-tree", tree,
                                 "-m",          message,
                                 "-m",          std::string(kStoreMark)};
  if (!parent.empty()) words.insert(words.end(), {"-p", parent});
  const auto made = git(std::move(words));
  if (!made.ok()) return made.error();
  return firstLineOf(*made);
}

Result<bool> GitStore::pushCommit(const std::string& commit, const std::string& before,
                                  bool replace) const {
  std::vector<std::string> words{"git",
                                 "-C",
                                 root_.string(),
                                 "--git-dir",
                                 (base_ / "objects.git").string(),
                                 "-c",
                                 "core.bare=true",
                                 "push",
                                 "--porcelain"};
  if (replace) words.push_back(fmt::format("--force-with-lease={}:{}", ref_, before));
  words.insert(words.end(), {remote_, commit + ":" + ref_});
  const auto output = childOutput(words);
  if (!output.ok()) return output.error();
  if (output->exit_code == 0) return true;
  // Whether the ref moved between the look and the push: each release of git has its own words.
  const auto now = remoteTip();
  if (now.ok() && *now != before) return false;
  // It is about to: another has locked it.
  for (const char* locked : {"cannot lock ref", "failed to update ref", "failed to lock"}) {
    if (output->out.find(locked) != std::string::npos ||
        output->err.find(locked) != std::string::npos) {
      return false;
    }
  }
  return Error{ErrorKind::refused, "git says: " + plainText(complaintIn(output->err)),
               root_.string()};
}

Result<GitStore::Pushed> GitStore::pushOnce(const std::set<std::string>& names,
                                            bool& is_done) const {
  const auto tip = fetchTip(false);
  if (!tip.ok()) return tip.error();
  if (Status own = ownsAll(*tip, false); !own) return own.error();
  const auto there = filesOf(*tip);
  if (!there.ok()) return there.error();
  std::set<std::string> added;
  Pushed pushed;
  std::error_code ignored;
  for (const std::string& name : names) {
    if (there->contains(name)) {
      ++pushed.there;
    } else if (std::filesystem::exists(files() / name, ignored)) {
      added.insert(name);
    } else {
      return Error{ErrorKind::not_found,
                   fmt::format("{} is neither in {} of {} nor here", name, ref_, remote_),
                   files().string()};
    }
  }
  is_done = added.empty();
  if (is_done) return pushed;
  pushed.added = added.size();
  const auto blobs = written(added);
  if (!blobs.ok()) return blobs.error();
  const auto tree = writeTree(*tip, *blobs);
  if (!tree.ok()) return tree.error();
  std::string parent = *tip;
  if (parent.empty()) {
    // A root without files: what a commit adds is what was pushed with it (see collect()).
    const auto empty = writeTree({}, {});
    if (!empty.ok()) return empty.error();
    auto root = commit(*empty, {}, "goldens");
    if (!root.ok()) return root.error();
    parent = std::move(*root);
  }
  const auto made = commit(*tree, parent, fmt::format("golden push: {}", added.size()));
  if (!made.ok()) return made.error();
  const auto arrived = pushCommit(*made, *tip, false);
  if (!arrived.ok()) return arrived.error();
  is_done = *arrived;
  return pushed;
}

Result<GitStore::Pushed> GitStore::push(const std::set<std::string>& names) const {
  if (Status made = makeRepository(); !made) return made.error();
  const auto lock = FolderLock::take(base_);
  if (!lock.ok()) return lock.error();
  for (int attempt = 1; attempt <= kMaxPushes; ++attempt) {
    bool is_done = false;
    auto pushed = pushOnce(names, is_done);
    if (!pushed.ok()) return pushed;
    pushed->attempts = attempt;
    if (is_done) return pushed;
    waitForOthers(attempt);
  }
  return Error{ErrorKind::refused,
               fmt::format("others changed {} each of {} times; try again", ref_, kMaxPushes),
               root_.string()};
}

}  // namespace rocinante
