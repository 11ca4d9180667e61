#include "golden/report/report_reader.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/base/json_parse.h"
#include "core/base/json_read.h"
#include "golden/report/report_pictures.h"
#include "golden/report/report_runs.h"
#include "golden/suite/suite_case.h"
#include "golden/suite/suite_plan.h"
#include "golden/why/frame_why.h"
#include "golden/why/run_pictures.h"

namespace rocinante {
namespace {

using ReportJson = nlohmann::json;

constexpr std::uint64_t kMaxReportBytes = std::uint64_t{256} << 20U;
constexpr char kReportFileName[] = "report.json";

Error brokenReport(const std::filesystem::path& file, std::string what) {
  return {ErrorKind::damaged, "is not a report of `golden run`: " + std::move(what), file.string()};
}

template <std::size_t N>
std::optional<std::array<double, N>> numbersIn(const ReportJson& object, const char* key) {
  const ReportJson& list = arrayIn(object, key);
  if (list.size() != N) return std::nullopt;
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) {
    if (!list[i].is_number()) return std::nullopt;
    numbers[i] = list[i].template get<double>();
  }
  return numbers;
}

/// Skips what is no hash: hashes only explain failures and decide no verdict.
FileHashes cellFilesOf(const ReportJson& root) {
  FileHashes files;
  const ReportJson& found = fieldIn(root, "cell_files");
  if (!found.is_object()) return files;
  for (const auto& [name, hash] : found.items()) {
    if (hash.is_string() && hash.get_ref<const std::string&>().size() == 64) files[name] = hash;
  }
  return files;
}

void readWhy(const ReportJson& entry, JudgedFrame& judged) {
  const ReportJson& found = fieldIn(entry, "why");
  if (!found.is_object()) return;
  auto why = std::make_shared<FrameWhy>();
  const bool is_redrawn = fieldIn(found, "estimated") == false;
  why->basis = is_redrawn ? GoldenBasis::redrawn : GoldenBasis::guessed;
  why->blame.differing = numberIn<std::int64_t>(found, "differing");
  why->files = textsIn(found, "files");
  for (const ReportJson& link : arrayIn(found, "links")) {
    if (!link.is_object()) continue;
    LinkChange& change = why->blame.changes.emplace_back();
    change.name = {textIn(link, "device"), textIn(link, "link")};
    change.pixels = numberIn<std::int64_t>(link, "pixels");
    change.kind = enumeratorNamed(textIn(link, "kind"), ChangeKind::camera).value_or(change.kind);
    change.inset = textIn(link, "inset");
    change.camera = textIn(link, "camera");
    change.moved_px = numbersIn<2>(link, "moved_px");
    change.color_shift = numbersIn<3>(link, "color_shift").value_or(std::array<double, 3>{});
  }
  for (const ReportJson& item : arrayIn(found, "state")) {
    if (!item.is_object()) continue;
    StateChange& change = why->state.emplace_back();
    change.item = textIn(item, "item");
    change.text = textIn(item, "text");
  }
  why->causes = textsIn(found, "causes");
  why->common_cause = textIn(found, "common_cause");
  judged.why = std::move(why);
}

void readFigures(const ReportJson& entry, JudgedFrame& judged) {
  Comparison& found = judged.comparison;
  found.differing = numberIn<std::int64_t>(entry, "differing");
  found.max = numberIn<int>(entry, "max");
  const ReportJson& worst = fieldIn(entry, "worst");
  found.worst_x = numberIn<int>(worst, "x");
  found.worst_y = numberIn<int>(worst, "y");
  found.worst_tile_mean = numberIn<double>(entry, "worst_tile_mean");
  found.worst_tile_over = numberIn<std::int64_t>(entry, "worst_tile_over");
  found.rule = judged.rule;
  const ReportJson& over = fieldIn(entry, "pixels_over");
  found.over_1 = numberIn<std::int64_t>(over, "1");
  found.over_2 = numberIn<std::int64_t>(over, "2");
  found.over_8 = numberIn<std::int64_t>(over, "8");
  found.over_32 = numberIn<std::int64_t>(over, "32");
  judged.render_ms = numberIn<double>(entry, "render_ms");
  judged.judge_ms = numberIn<double>(entry, "judge_ms");
}

void readLimits(const ReportJson& entry, JudgedFrame& judged) {
  Tolerance& tolerance = judged.tolerance;
  tolerance.name = textIn(entry, "tolerance");
  judged.limit_from = textIn(entry, "limit_from");
  const ReportJson& limits = fieldIn(entry, "limits");
  tolerance.exact = !limits.is_object() || limits.empty();
  tolerance.tile_mean = numberIn<double>(limits, "tile_mean");
  tolerance.tile_over = numberIn<std::int64_t>(limits, "tile_over");
  tolerance.level = numberIn<int>(limits, "level", tolerance.level);
  tolerance.percent = numberIn<int>(limits, "percent", tolerance.percent);
  for (const ReportJson& mask : arrayIn(entry, "masks")) {
    if (!mask.is_object()) continue;
    judged.masks.push_back({textIn(mask, "mask"), numberIn<std::int64_t>(mask, "pixels")});
    if (fieldIn(mask, "own") == true) judged.own_masks = judged.masks.size();
  }
}

void readGolden(const ReportJson& entry, JudgedFrame& judged) {
  const ReportJson& found = fieldIn(entry, "golden");
  if (!found.is_object()) return;
  AcceptedPicture& golden = judged.golden.emplace();
  golden.key = textIn(found, "key", judged.key);  // older reports have none
  golden.picture = textIn(found, "picture");
  golden.pixels = textIn(found, "pixels");
  golden.accepted_by = textIn(found, "accepted_by");
  golden.accepted_at = textIn(found, "accepted_at");
  golden.reason = textIn(found, "reason");
  if (found.contains("coverage")) golden.coverage = textsIn(found, "coverage");
  // The report only says whether they are equal.
  const auto equal = [&](const char* key) { return fieldIn(found, key) == true; };
  if (equal("inputs_equal")) golden.inputs = judged.inputs;
  if (equal("session_equal")) golden.session = judged.session;
  // Older reports know of no decoded packets.
  if (!found.contains("decoded_equal") || equal("decoded_equal")) golden.decoded = judged.decoded;
}

Result<JudgedFrame> frameOf(const ReportJson& entry, const SuiteReport& report,
                            const std::filesystem::path& file) {
  if (!entry.is_object()) return brokenReport(file, "a frame is not an object");
  JudgedFrame judged;
  judged.frame.name = textIn(entry, "name");
  // The name is also used in file names.
  if (judged.frame.name.empty() || judged.frame.name.size() > 240 ||
      judged.frame.name.front() == '.' || !isFileText(judged.frame.name)) {
    return brokenReport(file, "a frame's name cannot be a file name");
  }
  const auto verdict = enumeratorNamed(textIn(entry, "verdict"), FrameVerdict::unexpected);
  if (!verdict) return brokenReport(file, "frame " + judged.frame.name + " has no verdict");
  judged.verdict = *verdict;
  judged.frame.case_name = textIn(entry, "case");
  judged.frame.camera = textIn(entry, "camera");
  judged.frame.tags = textsIn(entry, "tags");
  judged.frame.place = numberIn<std::size_t>(entry, "place");
  judged.frame.line = numberIn<int>(entry, "line");
  if (entry.contains("log_time_ns")) {
    judged.frame.time = LogTime(Nanoseconds(numberIn<std::int64_t>(entry, "log_time_ns")));
  }
  judged.rule = textIn(entry, "rule");
  judged.expectation = textIn(entry, "expectation");
  judged.key = textIn(entry, "key");
  judged.pixels = textIn(entry, "pixels");
  judged.inputs = textIn(entry, "inputs");
  judged.session = report.session;
  judged.decoded = report.decoded;
  judged.lacks = textsIn(entry, "lacks");
  if (entry.contains("coverage")) judged.coverage = readCoverage(entry);
  readFigures(entry, judged);
  readLimits(entry, judged);
  readGolden(entry, judged);
  readWhy(entry, judged);
  return judged;
}

/// Reads the pictures of the run; `pixels` empty: unknown.
Status readPictures(const std::filesystem::path& folder, JudgedFrame& judged) {
  if (isFine(judged.verdict)) return {};
  const std::string stem = (folder / judged.frame.name).string();
  std::error_code ignored;
  const auto read = [&](const char* what, const std::string& pixels,
                        std::optional<Picture>& picture) -> Status {
    const std::filesystem::path file = stem + what;
    if (!std::filesystem::exists(file, ignored)) return {};
    auto found = readPng(file);
    if (!found.ok()) return found.error();
    if (!pixels.empty() && pictureXxh3(*found) != pixels) {
      return Error{ErrorKind::damaged, "is not the picture that report.json lists", file.string()};
    }
    picture = std::move(*found);
    return {};
  };
  if (auto frame = read(".frame.png", judged.pixels, judged.drawn); !frame) return frame;
  return read(".golden.png", judged.golden ? judged.golden->pixels : "", judged.accepted);
}

/// The pictures of a run and the copy of its log, as far as they are there.
Status readRunFiles(const std::filesystem::path& folder, JudgedRun& run) {
  std::error_code ignored;
  std::vector<RunPicture> pictures;
  for (std::size_t i = 0; i < run.pictures.size(); ++i) {
    const std::filesystem::path file = folder / runPictureFile(run, i);
    if (!std::filesystem::exists(file, ignored)) continue;
    auto picture = readPng(file);
    if (!picture.ok()) return picture.error();
    run.pictures[i].picture = std::move(*picture);
    pictures.push_back(std::move(run.pictures[i]));
  }
  run.pictures = std::move(pictures);
  const std::filesystem::path file = folder / runLogFile(run);
  if (run.log_bytes.empty() || !std::filesystem::exists(file, ignored)) return {};
  auto log = readFile(file, kMaxRunLogBytes);
  if (!log.ok()) return log.error();
  if (hexOf(xxh3(bytesOf(*log))) != run.log_bytes) {
    return Error{ErrorKind::damaged, "is not the log that report.json lists", file.string()};
  }
  run.log_copy = std::make_shared<const std::string>(std::move(*log));
  return {};
}

}  // namespace

Result<SuiteReport> parseReport(std::string_view text, const std::filesystem::path& file) {
  const Result<ReportJson> parsed = parseJson<ReportJson>(text);
  if (!parsed) return brokenReport(file, parsed.error().what);
  const ReportJson& root = *parsed;
  if (!root.is_object()) return brokenReport(file, "it is not a JSON object");
  if (root.value("format", ReportJson()) != 1) {
    return Error{ErrorKind::unsupported, "the report has a format other than 1", file.string()};
  }
  SuiteReport report;
  report.suite = textIn(root, "suite");
  report.cell = textIn(root, "cell");
  report.log = textIn(root, "log");
  report.renderer = textIn(root, "renderer");
  report.session = textIn(root, "session");
  report.decoded = textIn(root, "decoded");
  report.made_at = textIn(root, "made_at");
  report.run_command = textIn(root, "run_command");
  report.approve_command = textIn(root, "approve_command");
  report.run_one_command = textIn(root, "run_one_command");
  report.approve_one_command = textIn(root, "approve_one_command");
  report.approve_from_command = textIn(root, "approve_from_command");
  report.notes = textsIn(root, "notes");
  report.cell_files = cellFilesOf(root);
  if (const ReportJson& shard = fieldIn(root, "shard"); shard.is_object()) {
    report.shard = numberIn<int>(shard, "number", 1);
    report.shards = numberIn<int>(shard, "of", 1);
    if (report.shard < 1 || report.shard > report.shards || report.shards > kMaxShards) {
      return brokenReport(file, "its shard is not valid");
    }
  }
  const ReportJson& frames = fieldIn(root, "frames");
  if (!frames.is_array()) return brokenReport(file, "it has no `frames`");
  for (const ReportJson& entry : frames) {
    auto judged = frameOf(entry, report, file);
    if (!judged.ok()) return judged.error();
    report.frames.push_back(std::move(*judged));
  }
  report.runs = readRunsJson(fieldIn(root, "runs"));
  return report;
}

Result<SuiteReport> readReport(const std::filesystem::path& folder) {
  const auto text = readFile(folder / kReportFileName, kMaxReportBytes);
  if (!text.ok() && text.error().kind == ErrorKind::not_found) {
    return Error{ErrorKind::not_found, "has no report of `golden run`", folder.string()};
  }
  if (!text.ok()) return text.error();
  auto report = parseReport(*text, folder / kReportFileName);
  if (!report.ok()) return report;
  for (JudgedFrame& judged : report->frames) {
    if (auto read = readPictures(folder, judged); !read) return read.error();
  }
  for (JudgedRun& run : report->runs) {
    if (auto read = readRunFiles(folder, run); !read) return read.error();
  }
  const auto small = readFile(folder / kPagePicturesFile, kMaxReportBytes);
  if (small.ok()) addPagePictures(*small, *report);
  return report;
}

}  // namespace rocinante
