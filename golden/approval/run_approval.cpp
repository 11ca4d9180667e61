#include "golden/approval/run_approval.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/log/log_reader.h"
#include "golden/approval/staging_folder.h"
#include "golden/store/folder_lock.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxCopiedLogBytes = std::uint64_t{4} << 30U;

/// Reads the whole log, so that only whole ones are accepted.
Result<SessionHashes> hashesOfWhole(const std::filesystem::path& log) {
  auto reader = LogReader::open(log);
  if (!reader.ok()) return reader.error();
  auto hashes = sessionHashes(*reader);
  if (!hashes.ok()) return hashes.error();
  if (!reader->summary().closed || !reader->unreadable().empty()) {
    return Error{ErrorKind::damaged, "not accepted because the log is damaged or has no end",
                 log.string()};
  }
  if (reader->summary().messages == 0) {
    return Error{ErrorKind::refused, "not accepted because the log has no message", log.string()};
  }
  return hashes;
}

Status makeLogFolder(const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (!fault) return {};
  return Error{ErrorKind::unreadable, "cannot create: " + fault.message(), folder.string()};
}

}  // namespace

Result<RunApproved> approveRun(const GoldenFolder& folder, const RunCandidate& candidate) {
  const std::filesystem::path place = folder.hasStore() ? folder.store() : folder.goldens();
  for (const auto& needed : {folder.goldens(), place}) {
    if (Status made = makeLogFolder(needed); !made) return made.error();
  }
  // The copy is judged, not the file, which may change meanwhile.
  const auto staging = StagingFolder::make(place);
  if (!staging.ok()) return staging.error();
  const auto bytes = readFile(candidate.log, kMaxCopiedLogBytes);
  if (!bytes.ok()) return bytes.error();
  const std::filesystem::path copy = staging->path() / "1.mcap";
  if (Status written = writeFileWhole(copy, bytesOf(*bytes), true); !written)
    return written.error();
  const auto hashes = hashesOfWhole(copy);
  if (!hashes.ok()) return Error{hashes.error().kind, hashes.error().what, candidate.log.string()};

  AcceptedRun accepted;
  accepted.bytes = hexOf(xxh3(bytesOf(*bytes)));
  accepted.session = hashes->content;
  accepted.decoded = hashes->decoded;
  accepted.log = folder.hasStore()
                     ? accepted.session + ".mcap"
                     : fmt::format("{}.{}.mcap", candidate.run, accepted.bytes.substr(0, 12));
  accepted.accepted_by = candidate.accepted_by;
  accepted.accepted_at = candidate.accepted_at;
  accepted.reason = candidate.reason;
  accepted.kinematics = candidate.kinematics;
  accepted.masks = candidate.masks;
  if (!candidate.cell_files.empty()) accepted.cell = cellKey(candidate.cell_files);

  const auto lock = FolderLock::take(folder.goldens());
  if (!lock.ok()) return lock.error();
  auto manifest = Manifest::read(folder.goldens());
  if (!manifest.ok()) return manifest.error();
  std::vector<AcceptedRun>& runs = manifest->runs[candidate.run];
  const std::vector<AcceptedRun> before = runs;
  const auto isIt = [&](const AcceptedRun& one) {
    return one.session == accepted.session && one.decoded == accepted.decoded;
  };
  const auto same = std::ranges::find_if(runs, isIt);
  // With another model the same log means another motion.
  const bool is_there = same != runs.end() && same->kinematics == accepted.kinematics;
  if (is_there && folder.verify(*same) && (!candidate.replace || runs.size() == 1)) {
    return RunApproved::already;
  }
  if (candidate.replace) runs.clear();
  std::erase_if(runs, isIt);
  if (runs.size() >= kMaxOfOneRun) {
    return Error{ErrorKind::refused,
                 fmt::format("this run already has {} accepted logs, the limit; --replace begins "
                             "anew",
                             kMaxOfOneRun),
                 "run " + candidate.run};
  }
  runs.push_back(accepted);
  if (!accepted.cell.empty()) {
    manifest->cells[accepted.cell] = candidate.cell_files;
    manifest->texts.insert(candidate.cell_texts.begin(), candidate.cell_texts.end());
  }
  manifest->dropUnusedCells();
  std::error_code fault;
  std::filesystem::rename(copy, place / accepted.log, fault);
  if (fault) {
    return Error{ErrorKind::unreadable, "cannot rename: " + fault.message(),
                 (place / accepted.log).string()};
  }
  if (Status written = manifest->write(folder.goldens()); !written) return written.error();
  // A store is shared: nothing in it is removed.
  const std::set<std::string> used = manifest->runFiles();
  for (const AcceptedRun& old : before) {
    if (!used.contains(old.log)) std::filesystem::remove(folder.goldens() / old.log, fault);
  }
  return RunApproved::added;
}

}  // namespace rocinante
