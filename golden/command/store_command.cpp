#include <fmt/format.h>

#include "golden/approval/golden_folder.h"
#include "golden/approval/manifest.h"
#include "golden/command/commands.h"
#include "golden/suite/suite.h"

namespace rocinante {
namespace {

/// The store of a suite; bad_argument when it is not a ref of git.
Result<GitStore> storeOf(const Suite& suite) {
  if (suite.store_ref.empty()) {
    return Error{ErrorKind::bad_argument, "its `store` is not a ref of git, as git:refs/goldens",
                 suite.file.string()};
  }
  return GitStore::open(suite.file.parent_path(), suite.store_ref);
}

/// What a manifest.json of some branch names. Other programs use the name too; what could be ours
/// and cannot be read ends the collection, or its pictures would be lost.
Result<std::set<std::string>> namesInManifest(const std::string& text, const std::string& place) {
  const auto manifest = Manifest::parse(text, place);
  if (manifest.ok()) return manifest->storeNames();
  const bool may_be_ours = text.find("\"pixels\"") != text.npos || text.find(".mcap") != text.npos;
  if (may_be_ours) return manifest.error();
  return std::set<std::string>();
}

}  // namespace

cli::CommandLine addPushCommand(cli::CommandLine app, PushArguments& arguments) {
  const cli::CommandLine command = app.addSubcommand(
      "push", "put accepted pictures and logs into the ref that the suite's `store` names");
  command.addOption("SUITE", arguments.suites, "suites with `store = \"git:refs/...\"`").required();
  return command;
}

cli::CommandLine addGcCommand(cli::CommandLine app, GcArguments& arguments) {
  const cli::CommandLine command =
      app.addSubcommand("gc", "remove from the ref of the suite's `store` what no branch names");
  command.addOption("SUITE", arguments.suite, "a suite with `store = \"git:refs/...\"`").required();
  command
      .addOption("--keep-days", arguments.keep_days,
                 "keep what was pushed in the last days: its branch may not be there yet")
      .within(0, 3650)
      .showDefault();
  command.addFlag("-n,--dry-run", arguments.dry_run, "only tell what would be removed");
  return command;
}

Result<cli::Exit> runPushCommand(const PushArguments& arguments) {
  for (const std::filesystem::path& file : arguments.suites) {
    const auto suite = readSuite(file);
    if (!suite.ok()) return suite.error();
    const auto store = storeOf(*suite);
    if (!store.ok()) return store.error();
    const auto manifest = Manifest::read(suite->goldens);
    if (!manifest.ok()) return manifest.error();
    const auto pushed = store->push(manifest->storeNames());
    if (!pushed.ok()) return pushed.error();
    fmt::print("{}: {} added, {} there already{}\n", store->ref(), pushed->added, pushed->there,
               pushed->attempts > 1 ? fmt::format(" (attempt {})", pushed->attempts) : "");
  }
  return cli::Exit::done;
}

Result<cli::Exit> runGcCommand(const GcArguments& arguments) {
  const auto suite = readSuite(arguments.suite);
  if (!suite.ok()) return suite.error();
  const auto store = storeOf(*suite);
  if (!store.ok()) return store.error();
  const auto collected = store->collect(namesInManifest, arguments.keep_days, arguments.dry_run);
  if (!collected.ok()) return collected.error();
  for (const std::string& name : collected->removed) {
    fmt::print("{} {}\n", arguments.dry_run ? "would remove" : "removed", name);
  }
  fmt::print("{}: {} kept, {} {}\n", store->ref(), collected->kept, collected->removed.size(),
             arguments.dry_run ? "would be removed" : "removed");
  return cli::Exit::done;
}

}  // namespace rocinante
