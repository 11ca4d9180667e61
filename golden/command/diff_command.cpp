#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "golden/approval/golden_folder.h"
#include "golden/command/commands.h"
#include "golden/command/compare_command.h"
#include "golden/command/git_revision.h"
#include "golden/command/report_output.h"
#include "golden/command/suite_arguments.h"
#include "golden/judge/manifest_diff.h"
#include "golden/report/report.h"
#include "viewer/picture/lfs_pointer.h"

namespace rocinante {
namespace {

Result<Manifest> manifestThen(const GitRevision& revision, const std::filesystem::path& goldens) {
  const std::filesystem::path file = goldens / "manifest.json";
  const auto text = revision.file(file);
  if (!text.ok()) {
    if (text.error().kind == ErrorKind::not_found) return Manifest{};
    return text.error();
  }
  return Manifest::parse(*text, file);
}

Result<Picture> pictureThen(const GitRevision& revision, const GoldenFolder& folder,
                            const AcceptedPicture& accepted) {
  // A store keeps every picture ever accepted.
  if (folder.isInStore(accepted.picture, accepted.pixels)) return folder.read(accepted);
  const std::filesystem::path file = folder.goldens() / accepted.picture;
  const auto bytes = revision.file(file);
  if (!bytes.ok()) return bytes.error();
  if (isLfsPointer(bytesOf(*bytes))) {
    return Error{ErrorKind::unsupported,
                 "a Git LFS pointer, not the picture; `git lfs fetch` fetches it", file.string()};
  }
  auto picture = decodePng(bytesOf(*bytes), file.string());
  if (!picture.ok()) return picture.error();
  if (pictureXxh3(*picture) == accepted.pixels) return picture;
  return Error{ErrorKind::damaged, "is not the picture that the manifest listed at that revision",
               file.string()};
}

Result<std::vector<JudgedFrame>> changesIn(const GitRevision& revision, const GoldenFolder& folder,
                                           const std::string& since) {
  const auto then = manifestThen(revision, folder.goldens());
  if (!then.ok()) return then.error();
  const auto now = Manifest::read(folder.goldens());
  if (!now.ok()) return now.error();
  return manifestChanges(
      *then, [&](const AcceptedPicture& one) { return pictureThen(revision, folder, one); }, *now,
      [&](const AcceptedPicture& one) { return folder.read(one); }, since);
}

/// Whether a manifest.json is a manifest of goldens, now or at the revision: other programs use the
/// name too.
bool isOfGoldens(const GitRevision& revision, const std::filesystem::path& goldens) {
  const auto then = manifestThen(revision, goldens);
  if (then.ok() && !then->cases.empty()) return true;
  const auto now = Manifest::read(goldens);
  return now.ok() && !now->cases.empty();
}

/// The golden folders of suites of the repository that have a store.
Result<std::map<std::filesystem::path, GoldenFolder>> storesIn(const GitRevision& revision) {
  const auto files = revision.filesThatEndWith(".toml");
  if (!files.ok()) return files.error();
  std::map<std::filesystem::path, GoldenFolder> stores;
  for (const std::filesystem::path& file : *files) {
    // Skip files that are not suites.
    const auto suite = readSuite(revision.root() / file);
    if (!suite.ok()) continue;
    auto golden_folder = GoldenFolder::of(*suite);
    if (!golden_folder.ok() || !golden_folder->hasStore()) continue;
    stores.emplace(std::filesystem::absolute(suite->goldens).lexically_normal(),
                   std::move(*golden_folder));
  }
  return stores;
}

Result<std::vector<JudgedFrame>> changesInRepository(const std::string& since) {
  const auto revision = GitRevision::open(".", since);
  if (!revision.ok()) return revision.error();
  const auto files = revision->filesThatEndWith("manifest.json");
  if (!files.ok()) return files.error();
  const auto stores = storesIn(*revision);
  if (!stores.ok()) return stores.error();
  std::vector<JudgedFrame> all;
  for (const std::filesystem::path& file : *files) {
    const std::filesystem::path folder =
        (revision->root() / file.parent_path() / "").lexically_normal().parent_path();
    if (file.filename() != "manifest.json" || !isOfGoldens(*revision, folder)) continue;
    const auto store = stores->find(folder);
    auto changes = changesIn(
        *revision,
        store == stores->end() ? GoldenFolder(folder, std::filesystem::path()) : store->second,
        since);
    if (!changes.ok()) return changes.error();
    for (JudgedFrame& judged : *changes) {
      // The suite's path, in characters allowed in a file name.
      std::string place = file.parent_path().generic_string();
      std::ranges::replace(place, '/', '.');
      if (!place.empty()) judged.frame.name = safeName(place + "." + judged.frame.name);
      all.push_back(std::move(judged));
    }
  }
  return all;
}

Result<std::vector<JudgedFrame>> allChanges(const DiffArguments& arguments) {
  if (arguments.suite.empty()) return changesInRepository(arguments.revision);
  const auto suite = readSuite(arguments.suite);
  if (!suite.ok()) return suite.error();
  const auto revision = GitRevision::open(arguments.suite.parent_path(), arguments.revision);
  if (!revision.ok()) return revision.error();
  const auto folder = GoldenFolder::of(*suite);
  if (!folder.ok()) return folder.error();
  return changesIn(*revision, *folder, arguments.revision);
}

}  // namespace

cli::CommandLine addDiffCommand(cli::CommandLine app, DiffArguments& arguments) {
  const cli::CommandLine command =
      app.addSubcommand("diff", "list the goldens that changed since a git revision");
  command.addOption("REV", arguments.revision, "a commit, branch or tag").required();
  command.addOption("SUITE", arguments.suite, "default: every suite of the repository");
  command.addOption("--report", arguments.report, "folder for index.html and the pictures");
  command
      .addOption("--json", arguments.json_file, "write the changes as JSON; - is standard output")
      .bareMeans("-");
  return command;
}

Result<cli::Exit> runDiffCommand(const DiffArguments& arguments) {
  auto frames = allChanges(arguments);
  if (!frames.ok()) return frames.error();
  const std::size_t goldens = frames->size();
  if (goldens == 0) {
    return Error{ErrorKind::not_found,
                 fmt::format("no goldens now or at {}, so there is nothing to compare",
                             plainText(arguments.revision)),
                 arguments.suite.string()};
  }
  std::erase_if(*frames,
                [](const JudgedFrame& judged) { return judged.verdict == FrameVerdict::same; });
  SuiteReport report;
  report.suite = arguments.suite.string();
  report.made_at = nowText();
  report.run_command = "rocinante golden diff " + arguments.revision;
  if (!report.suite.empty()) report.run_command += " " + report.suite;
  report.frames = std::move(*frames);
  if (arguments.json_file != "-") {
    for (const JudgedFrame& judged : report.frames) {
      fmt::print("{:<13} {}: {}\n", nameOf(judged.verdict), judged.frame.name, judged.rule);
    }
    fmt::print("{} of {} changed since {}\n", report.frames.size(), countText(goldens, "golden"),
               plainText(arguments.revision));
  }
  if (auto written = writeReportFiles(report, {arguments.report, {}, arguments.json_file});
      !written)
    return written.error();
  return report.frames.empty() ? cli::Exit::done : exitOf(report.verdict());
}

}  // namespace rocinante
