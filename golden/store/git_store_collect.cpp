#include <fmt/format.h>

#include "golden/store/folder_lock.h"
#include "golden/store/git_store.h"
#include "golden/store/git_words.h"

namespace rocinante {

Result<std::set<std::string>> GitStore::namedBy(const NamesIn& names_in,
                                                std::size_t& branches) const {
  const auto fetched =
      git({"fetch", "--quiet", "--no-tags", "--refmap=", "--depth=1", "--filter=blob:none",
           "--prune", remote_, "+refs/heads/*:refs/seen/heads/*", "+refs/tags/*:refs/seen/tags/*"});
  if (!fetched.ok()) return fetched.error();
  std::set<std::string> named;
  std::set<std::string> looked_at;  // manifests by hash: branches mostly share them
  const auto look = [&](const auto& run, const std::string& prefix) -> Status {
    const auto refs = run({"for-each-ref", "--format=%(refname)", prefix});
    if (!refs.ok()) return refs.error();
    for (const std::string& one : partsOf(*refs, '\n')) {
      ++branches;
      const auto listed = run({"ls-tree", "-r", "-z", "--full-tree", one});
      // A tag of something that is no commit has no tree.
      if (!listed.ok() && one.starts_with("refs/seen/tags/")) continue;
      if (!listed.ok()) return listed.error();
      for (const std::string& entry : partsOf(*listed, '\0')) {
        // "100644 blob HASH\tPATH"
        const std::size_t tab = entry.find('\t');
        const std::string path = tab == entry.npos ? "" : entry.substr(tab + 1);
        if (!entry.starts_with("100") || !("/" + path).ends_with("/manifest.json")) continue;
        const std::size_t begin = entry.find(' ', entry.find(' ') + 1) + 1;
        const std::string hash = entry.substr(begin, tab - begin);
        if (!looked_at.insert(hash).second) continue;
        const auto text = run({"cat-file", "blob", hash});
        if (!text.ok()) return text.error();
        auto names = names_in(*text, one + ":" + path);
        if (!names.ok()) return names.error();
        named.merge(*names);
      }
    }
    return {};
  };
  const auto in_store = [&](std::vector<std::string> words) { return git(std::move(words)); };
  const auto in_repository = [&](std::vector<std::string> words) {
    return gitIn(root_, std::move(words));
  };
  if (Status seen = look(in_store, "refs/seen"); !seen) return seen.error();
  if (Status here = look(in_repository, "refs/heads"); !here) return here.error();
  return named;
}

Result<GitStore::Collected> GitStore::collectOnce(const NamesIn& names_in, int keep_days, bool dry,
                                                  bool& is_done) const {
  const auto tip = fetchTip(true);
  if (!tip.ok()) return tip.error();
  if (Status own = ownsAll(*tip, true); !own) return own.error();
  const auto there = filesOf(*tip);
  if (!there.ok()) return there.error();
  Collected collected;
  auto kept = namedBy(names_in, collected.branches);
  if (!kept.ok()) return kept.error();
  if (!tip->empty() && keep_days > 0) {
    // The first commit, which collect() itself makes, adds nothing.
    const auto young =
        git({"-c", "log.showRoot=false", "log", "-z", "--format=", "--name-only", "--no-renames",
             "--diff-filter=A", fmt::format("--since={}.days", keep_days), *tip});
    if (!young.ok()) return young.error();
    for (std::string& name : partsOf(*young, '\0')) kept->insert(std::move(name));
  }
  Blobs left;
  for (const auto& [name, hash] : *there) {
    if (kept->contains(name)) {
      left[name] = hash;
    } else {
      collected.removed.push_back(name);
    }
  }
  collected.kept = left.size();
  is_done = dry || collected.removed.empty();
  if (is_done) return collected;
  const auto tree = writeTree({}, left);
  if (!tree.ok()) return tree.error();
  // Without a parent: the removed files are in no history, so the server may drop them.
  const auto made = commit(*tree, {}, fmt::format("golden gc: {}", collected.removed.size()));
  if (!made.ok()) return made.error();
  const auto arrived = pushCommit(*made, *tip, true);
  if (!arrived.ok()) return arrived.error();
  is_done = *arrived;
  return collected;
}

Result<GitStore::Collected> GitStore::collect(const NamesIn& names_in, int keep_days,
                                              bool dry) const {
  if (Status has = needRemote(); !has) return has.error();
  if (Status made = makeRepository(); !made) return made.error();
  const auto lock = FolderLock::take(base_);
  if (!lock.ok()) return lock.error();
  for (int attempt = 1; attempt <= kMaxPushes; ++attempt) {
    bool is_done = false;
    auto collected = collectOnce(names_in, keep_days, dry, is_done);
    if (!collected.ok() || is_done) return collected;
    waitForOthers(attempt);
  }
  return Error{ErrorKind::refused,
               fmt::format("others changed {} each of {} times; try again", ref_, kMaxPushes),
               root_.string()};
}

}  // namespace rocinante
