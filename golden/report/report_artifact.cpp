#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/archive/zip_archive.h"
#include "core/base/atomic_file.h"
#include "core/base/plain_text.h"
#include "core/bundle/private_folder.h"
#include "golden/report/report_pictures.h"
#include "golden/report/report_reader.h"
#include "golden/suite/suite_case.h"

namespace rocinante {
namespace {

constexpr std::string_view kReportName = "report.json";
constexpr std::string_view kFrameEnding = ".frame.png";
constexpr std::string_view kRunLogEnding = ".run.mcap";  // runLogFile()
/// As golden/report/report_reader.cpp reads them.
constexpr std::uint64_t kMaxJsonBytes = std::uint64_t{256} << 20U;
constexpr std::uint64_t kMaxFrameBytes = std::uint64_t{256} << 20U;
constexpr std::uint64_t kMaxUnpackedBytes = std::uint64_t{4} << 30U;
/// Folders below each other; services of CI add one or two to those of the job.
constexpr int kMaxDepth = 8;

std::string_view lastOf(std::string_view path) { return path.substr(path.rfind('/') + 1); }

/// The one report among several paths.
Result<std::string> onlyReport(const std::vector<std::string>& found, const std::string& artifact) {
  if (found.empty()) {
    return Error{ErrorKind::not_found, "has no report of `golden run --report`", artifact};
  }
  if (found.size() > 1) {
    return Error{ErrorKind::refused,
                 fmt::format("has {} reports ({}, {}): give the folder of one", found.size(),
                             plainText(found[0]), plainText(found[1])),
                 artifact};
  }
  return found.front();
}

Result<std::filesystem::path> reportIn(const std::filesystem::path& folder) {
  std::error_code fault;
  if (std::filesystem::exists(folder / kReportName, fault)) return folder;
  std::vector<std::string> found;
  std::filesystem::recursive_directory_iterator entry(folder, fault);
  for (; !fault && entry != std::filesystem::recursive_directory_iterator();
       entry.increment(fault)) {
    if (entry.depth() >= kMaxDepth) entry.disable_recursion_pending();
    if (entry->path().filename() == kReportName) {
      found.push_back(entry->path().parent_path().string());
    }
  }
  if (fault) {
    return Error{ErrorKind::unreadable, "cannot be read: " + fault.message(), folder.string()};
  }
  auto only = onlyReport(found, folder.string());
  if (!only.ok()) return only.error();
  return std::filesystem::path(*only);
}

/// Writes what readReport() needs of an archive into a folder of ours, by names of ours.
Status unpackReport(const ZipArchive& archive, const std::string& artifact,
                    const std::filesystem::path& folder) {
  std::vector<std::string> reports;
  for (const std::string& name : archive.names()) {
    if (lastOf(name) == kReportName) reports.push_back(name);
  }
  const auto report = onlyReport(reports, artifact);
  if (!report.ok()) return report.error();
  const std::string beside = report->substr(0, report->size() - kReportName.size());
  std::uint64_t unpacked = 0;
  for (const std::string& name : archive.names()) {
    const std::string_view file = lastOf(name);
    const bool is_frame = file.ends_with(kFrameEnding) && file.front() != '.' && isFileText(file);
    const bool is_log = file.ends_with(kRunLogEnding) && file.front() != '.' && isFileText(file);
    const bool is_json = file == kReportName || file == kPagePicturesFile;
    if (name != beside + std::string(file) || !(is_frame || is_log || is_json)) continue;
    const auto content = archive.read(name, is_log     ? kMaxRunLogBytes
                                            : is_frame ? kMaxFrameBytes
                                                       : kMaxJsonBytes);
    if (!content.ok()) return content.error();
    unpacked += content->size();
    if (unpacked > kMaxUnpackedBytes) {
      return Error{ErrorKind::refused,
                   fmt::format("the report in it has more than {} bytes", kMaxUnpackedBytes),
                   artifact};
    }
    // A name that is there twice is written once: the archive reads the first.
    if (auto written = writeFileWhole(folder / file, bytesOf(*content), true); !written) {
      return written;
    }
  }
  return {};
}

}  // namespace

Result<SuiteReport> readArtifact(const std::filesystem::path& artifact) {
  std::error_code ignored;
  if (std::filesystem::is_directory(artifact, ignored)) {
    const auto folder = reportIn(artifact);
    if (!folder.ok()) return folder.error();
    return readReport(*folder);
  }
  if (!std::filesystem::exists(artifact, ignored)) {
    return Error{ErrorKind::not_found, "no such file or folder", artifact.string()};
  }
  const auto archive = ZipArchive::open(artifact);
  if (!archive.ok()) return archive.error();
  const auto folder = PrivateFolder::make();
  if (!folder.ok()) return folder.error();
  if (auto unpacked = unpackReport(*archive, artifact.string(), (*folder)->path()); !unpacked) {
    return unpacked.error();
  }
  auto report = readReport((*folder)->path());
  if (report.ok()) return report;
  // The reader knows the folder that is deleted now.
  const std::string file = std::filesystem::path(report.error().where).filename().string();
  return Error{report.error().kind, report.error().what, artifact.string() + ": " + file};
}

}  // namespace rocinante
