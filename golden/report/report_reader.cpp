#include "golden/report/report_reader.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/base/json_parse.h"
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

/// A field of an object, if it exists and has the right type.
template <class T>
T fieldOf(const ReportJson& object, const char* key, T otherwise = {}) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if constexpr (std::is_same_v<T, std::string>) {
    return found->is_string() ? found->get<T>() : otherwise;
  } else {
    return found->is_number() ? found->get<T>() : otherwise;
  }
}

std::vector<std::string> textsOf(const ReportJson& object, const char* key) {
  std::vector<std::string> texts;
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array()) return texts;
  for (const ReportJson& item : *found) {
    if (item.is_string()) texts.push_back(item.get<std::string>());
  }
  return texts;
}

template <std::size_t N>
std::optional<std::array<double, N>> numbersIn(const ReportJson& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array() || found->size() != N) return std::nullopt;
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) {
    if (!(*found)[i].is_number()) return std::nullopt;
    numbers[i] = (*found)[i].template get<double>();
  }
  return numbers;
}

/// Skips what is no hash: hashes only explain failures and decide no verdict.
FileHashes cellFilesOf(const ReportJson& root) {
  FileHashes files;
  const auto found = root.find("cell_files");
  if (found == root.end() || !found->is_object()) return files;
  for (const auto& [name, hash] : found->items()) {
    if (hash.is_string() && hash.get_ref<const std::string&>().size() == 64) files[name] = hash;
  }
  return files;
}

/// The object in a field; empty when missing.
ReportJson objectIn(const ReportJson& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_object() ? *found : ReportJson::object();
}

std::optional<FrameVerdict> verdictNamed(const std::string& name) {
  for (const FrameVerdict verdict : kFrameVerdicts) {
    if (nameOf(verdict) == name) return verdict;
  }
  return std::nullopt;
}

void readWhy(const ReportJson& entry, JudgedFrame& judged) {
  const auto found = entry.find("why");
  if (found == entry.end() || !found->is_object()) return;
  auto why = std::make_shared<FrameWhy>();
  const auto estimated = found->find("estimated");
  const bool guessed = estimated == found->end() || *estimated != false;
  why->basis = guessed ? GoldenBasis::guessed : GoldenBasis::redrawn;
  why->blame.differing = fieldOf<std::int64_t>(*found, "differing");
  why->files = textsOf(*found, "files");
  const auto links = found->find("links");
  for (const ReportJson& link :
       links != found->end() && links->is_array() ? *links : ReportJson::array()) {
    if (!link.is_object()) continue;
    LinkChange& change = why->blame.changes.emplace_back();
    change.name = {fieldOf<std::string>(link, "device"), fieldOf<std::string>(link, "link")};
    change.pixels = fieldOf<std::int64_t>(link, "pixels");
    const std::string kind = fieldOf<std::string>(link, "kind");
    for (const ChangeKind one :
         {ChangeKind::moved, ChangeKind::appeared, ChangeKind::vanished, ChangeKind::shape,
          ChangeKind::color, ChangeKind::drawing, ChangeKind::camera}) {
      if (nameOf(one) == kind) change.kind = one;
    }
    change.inset = fieldOf<std::string>(link, "inset");
    change.camera = fieldOf<std::string>(link, "camera");
    change.moved_px = numbersIn<2>(link, "moved_px");
    change.color_shift = numbersIn<3>(link, "color_shift").value_or(std::array<double, 3>{});
  }
  const auto state = found->find("state");
  for (const ReportJson& item :
       state != found->end() && state->is_array() ? *state : ReportJson::array()) {
    if (!item.is_object()) continue;
    StateChange& change = why->state.emplace_back();
    change.item = fieldOf<std::string>(item, "item");
    change.text = fieldOf<std::string>(item, "text");
  }
  why->causes = textsOf(*found, "causes");
  why->common_cause = fieldOf<std::string>(*found, "common_cause");
  judged.why = std::move(why);
}

void readFigures(const ReportJson& entry, JudgedFrame& judged) {
  Comparison& found = judged.comparison;
  found.differing = fieldOf<std::int64_t>(entry, "differing");
  found.max = fieldOf<int>(entry, "max");
  const ReportJson worst = objectIn(entry, "worst");
  found.worst_x = fieldOf<int>(worst, "x");
  found.worst_y = fieldOf<int>(worst, "y");
  found.worst_tile_mean = fieldOf<double>(entry, "worst_tile_mean");
  found.worst_tile_over = fieldOf<std::int64_t>(entry, "worst_tile_over");
  found.rule = judged.rule;
  const ReportJson over = objectIn(entry, "pixels_over");
  found.over_1 = fieldOf<std::int64_t>(over, "1");
  found.over_2 = fieldOf<std::int64_t>(over, "2");
  found.over_8 = fieldOf<std::int64_t>(over, "8");
  found.over_32 = fieldOf<std::int64_t>(over, "32");
  judged.render_ms = fieldOf<double>(entry, "render_ms");
  judged.judge_ms = fieldOf<double>(entry, "judge_ms");
}

void readLimits(const ReportJson& entry, JudgedFrame& judged) {
  Tolerance& tolerance = judged.tolerance;
  tolerance.name = fieldOf<std::string>(entry, "tolerance");
  judged.limit_from = fieldOf<std::string>(entry, "limit_from");
  const ReportJson limits = objectIn(entry, "limits");
  tolerance.exact = limits.empty();
  tolerance.tile_mean = fieldOf<double>(limits, "tile_mean");
  tolerance.tile_over = fieldOf<std::int64_t>(limits, "tile_over");
  tolerance.level = fieldOf<int>(limits, "level", tolerance.level);
  tolerance.percent = fieldOf<int>(limits, "percent", tolerance.percent);
  const auto masks = entry.find("masks");
  if (masks == entry.end() || !masks->is_array()) return;
  for (const ReportJson& mask : *masks) {
    if (!mask.is_object()) continue;
    judged.masks.push_back(
        {fieldOf<std::string>(mask, "mask"), fieldOf<std::int64_t>(mask, "pixels")});
    const auto own = mask.find("own");
    if (own != mask.end() && *own == true) judged.own_masks = judged.masks.size();
  }
}

void readGolden(const ReportJson& entry, JudgedFrame& judged) {
  const auto found = entry.find("golden");
  if (found == entry.end() || !found->is_object()) return;
  AcceptedPicture& golden = judged.golden.emplace();
  golden.key = fieldOf<std::string>(*found, "key", judged.key);  // older reports have none
  golden.picture = fieldOf<std::string>(*found, "picture");
  golden.pixels = fieldOf<std::string>(*found, "pixels");
  golden.accepted_by = fieldOf<std::string>(*found, "accepted_by");
  golden.accepted_at = fieldOf<std::string>(*found, "accepted_at");
  golden.reason = fieldOf<std::string>(*found, "reason");
  if (found->contains("coverage")) golden.coverage = textsOf(*found, "coverage");
  // The report only says whether they are equal.
  const auto equal = [&](const char* key) {
    const auto flag = found->find(key);
    return flag != found->end() && *flag == true;
  };
  if (equal("inputs_equal")) golden.inputs = judged.inputs;
  if (equal("session_equal")) golden.session = judged.session;
  // Older reports know of no decoded packets.
  if (!found->contains("decoded_equal") || equal("decoded_equal")) golden.decoded = judged.decoded;
}

Result<JudgedFrame> frameOf(const ReportJson& entry, const SuiteReport& report,
                            const std::filesystem::path& file) {
  if (!entry.is_object()) return brokenReport(file, "a frame is not an object");
  JudgedFrame judged;
  judged.frame.name = fieldOf<std::string>(entry, "name");
  // The name is also used in file names.
  if (judged.frame.name.empty() || judged.frame.name.size() > 240 ||
      judged.frame.name.front() == '.' || !isFileText(judged.frame.name)) {
    return brokenReport(file, "a frame's name cannot be a file name");
  }
  const auto verdict = verdictNamed(fieldOf<std::string>(entry, "verdict"));
  if (!verdict) return brokenReport(file, "frame " + judged.frame.name + " has no verdict");
  judged.verdict = *verdict;
  judged.frame.case_name = fieldOf<std::string>(entry, "case");
  judged.frame.camera = fieldOf<std::string>(entry, "camera");
  judged.frame.tags = textsOf(entry, "tags");
  judged.frame.place = fieldOf<std::size_t>(entry, "place");
  judged.frame.line = fieldOf<int>(entry, "line");
  if (entry.contains("log_time_ns")) {
    judged.frame.time = LogTime(Nanoseconds(fieldOf<std::int64_t>(entry, "log_time_ns")));
  }
  judged.rule = fieldOf<std::string>(entry, "rule");
  judged.expectation = fieldOf<std::string>(entry, "expectation");
  judged.key = fieldOf<std::string>(entry, "key");
  judged.pixels = fieldOf<std::string>(entry, "pixels");
  judged.inputs = fieldOf<std::string>(entry, "inputs");
  judged.session = report.session;
  judged.decoded = report.decoded;
  judged.lacks = textsOf(entry, "lacks");
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
  report.suite = fieldOf<std::string>(root, "suite");
  report.cell = fieldOf<std::string>(root, "cell");
  report.log = fieldOf<std::string>(root, "log");
  report.renderer = fieldOf<std::string>(root, "renderer");
  report.session = fieldOf<std::string>(root, "session");
  report.decoded = fieldOf<std::string>(root, "decoded");
  report.made_at = fieldOf<std::string>(root, "made_at");
  report.run_command = fieldOf<std::string>(root, "run_command");
  report.approve_command = fieldOf<std::string>(root, "approve_command");
  report.run_one_command = fieldOf<std::string>(root, "run_one_command");
  report.approve_one_command = fieldOf<std::string>(root, "approve_one_command");
  report.approve_from_command = fieldOf<std::string>(root, "approve_from_command");
  report.notes = textsOf(root, "notes");
  report.cell_files = cellFilesOf(root);
  if (const auto shard = root.find("shard"); shard != root.end() && shard->is_object()) {
    report.shard = fieldOf<int>(*shard, "number", 1);
    report.shards = fieldOf<int>(*shard, "of", 1);
    if (report.shard < 1 || report.shard > report.shards || report.shards > kMaxShards) {
      return brokenReport(file, "its shard is not valid");
    }
  }
  const auto frames = root.find("frames");
  if (frames == root.end() || !frames->is_array()) return brokenReport(file, "it has no `frames`");
  for (const ReportJson& entry : *frames) {
    auto judged = frameOf(entry, report, file);
    if (!judged.ok()) return judged.error();
    report.frames.push_back(std::move(*judged));
  }
  if (const auto runs = root.find("runs"); runs != root.end()) report.runs = readRunsJson(*runs);
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
