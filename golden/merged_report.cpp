#include "golden/merged_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/atomic_file.h"
#include "golden/suite_case.h"
#include "golden/suite_plan.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

using ReportJson = nlohmann::json;

constexpr std::uint64_t kMostReportBytes = std::uint64_t{256} << 20U;
constexpr char kReportFileName[] = "report.json";

Error brokenReport(const std::filesystem::path& file, std::string what) {
  return {ErrorKind::damaged, "is no report of `golden run`: " + std::move(what), file.string()};
}

/// A field of an object, if it is there and of its kind.
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
    for (const ChangeKind one : {ChangeKind::moved, ChangeKind::appeared, ChangeKind::vanished,
                                 ChangeKind::shape, ChangeKind::color, ChangeKind::drawing}) {
      if (nameOf(one) == kind) change.kind = one;
    }
    const auto moved = link.find("moved_px");
    if (moved != link.end() && moved->is_array() && moved->size() == 2 && (*moved)[0].is_number() &&
        (*moved)[1].is_number()) {
      change.moved_px = {(*moved)[0].get<double>(), (*moved)[1].get<double>()};
    }
  }
  const auto state = found->find("state");
  for (const ReportJson& item :
       state != found->end() && state->is_array() ? *state : ReportJson::array()) {
    if (!item.is_object()) continue;
    StateChange& change = why->state.emplace_back();
    change.item = fieldOf<std::string>(item, "item");
    change.text = fieldOf<std::string>(item, "text");
  }
  judged.why = std::move(why);
}

void readFigures(const ReportJson& entry, JudgedFrame& judged) {
  Comparison& found = judged.comparison;
  found.max = fieldOf<int>(entry, "max");
  found.worst_tile_mean = fieldOf<double>(entry, "worst_tile_mean");
  found.rule = judged.rule;
  const auto over = entry.find("pixels_over");
  if (over != entry.end() && over->is_object()) {
    found.over_1 = fieldOf<std::int64_t>(*over, "1");
    found.over_2 = fieldOf<std::int64_t>(*over, "2");
    found.over_8 = fieldOf<std::int64_t>(*over, "8");
    found.over_32 = fieldOf<std::int64_t>(*over, "32");
  }
  judged.render_ms = fieldOf<double>(entry, "render_ms");
  judged.judge_ms = fieldOf<double>(entry, "judge_ms");
}

void readGolden(const ReportJson& entry, JudgedFrame& judged) {
  const auto found = entry.find("golden");
  if (found == entry.end() || !found->is_object()) return;
  AcceptedPicture& golden = judged.golden.emplace();
  golden.key = judged.key;
  golden.picture = fieldOf<std::string>(*found, "picture");
  golden.pixels = fieldOf<std::string>(*found, "pixels");
  golden.accepted_by = fieldOf<std::string>(*found, "accepted_by");
  golden.accepted_at = fieldOf<std::string>(*found, "accepted_at");
  golden.reason = fieldOf<std::string>(*found, "reason");
  // Only whether they are equal is told.
  const auto equal = [&](const char* key) {
    const auto flag = found->find(key);
    return flag != found->end() && *flag == true;
  };
  if (equal("inputs_equal")) golden.inputs = judged.inputs;
  if (equal("session_equal")) golden.session = judged.session;
}

Result<JudgedFrame> frameOf(const ReportJson& entry, const std::string& session,
                            const std::filesystem::path& file) {
  if (!entry.is_object()) return brokenReport(file, "a frame is no object");
  JudgedFrame judged;
  judged.frame.name = fieldOf<std::string>(entry, "name");
  // It names the files beside it.
  if (judged.frame.name.empty() || judged.frame.name.size() > 240 ||
      judged.frame.name.front() == '.' || !isFileText(judged.frame.name)) {
    return brokenReport(file, "a frame has no name that a file can have");
  }
  const auto verdict = verdictNamed(fieldOf<std::string>(entry, "verdict"));
  if (!verdict) return brokenReport(file, "frame " + judged.frame.name + " has no verdict");
  judged.verdict = *verdict;
  judged.frame.case_name = fieldOf<std::string>(entry, "case");
  judged.frame.camera = fieldOf<std::string>(entry, "camera");
  judged.frame.tags = textsOf(entry, "tags");
  if (entry.contains("log_time_ns")) {
    judged.frame.time = LogTime(Nanoseconds(fieldOf<std::int64_t>(entry, "log_time_ns")));
  }
  judged.rule = fieldOf<std::string>(entry, "rule");
  judged.tolerance.name = fieldOf<std::string>(entry, "tolerance");
  judged.limit_from = fieldOf<std::string>(entry, "limit_from");
  judged.expectation = fieldOf<std::string>(entry, "expectation");
  judged.key = fieldOf<std::string>(entry, "key");
  judged.pixels = fieldOf<std::string>(entry, "pixels");
  judged.inputs = fieldOf<std::string>(entry, "inputs");
  judged.session = session;
  readFigures(entry, judged);
  readGolden(entry, judged);
  readWhy(entry, judged);
  return judged;
}

/// The pictures that the run left, and the figures that only they tell.
Status readPictures(const std::filesystem::path& folder, JudgedFrame& judged) {
  if (isFine(judged.verdict)) return {};
  const std::string stem = (folder / judged.frame.name).string();
  std::error_code ignored;
  const auto read = [&](const char* what, std::optional<Picture>& picture) -> Status {
    const std::filesystem::path file = stem + what;
    if (!std::filesystem::exists(file, ignored)) return {};
    auto found = readPng(file);
    if (!found.ok()) return found.error();
    picture = std::move(*found);
    return {};
  };
  if (auto frame = read(".frame.png", judged.drawn); !frame) return frame;
  if (auto golden = read(".golden.png", judged.accepted); !golden) return golden;
  if (!judged.drawn || !judged.accepted) return {};
  std::string rule = std::move(judged.comparison.rule);
  judged.comparison = compare(*judged.drawn, *judged.accepted, Tolerance::exactly());
  judged.comparison.rule = std::move(rule);
  return {};
}

Status checkShards(const std::vector<SuiteReport>& parts) {
  std::map<std::string, std::set<int>> seen;
  std::map<std::string, const SuiteReport*> first;
  for (const SuiteReport& part : parts) {
    const auto refuse = [&](std::string what) {
      return Error{ErrorKind::refused, std::move(what), part.suite};
    };
    const SuiteReport& one = *first.emplace(part.suite, &part).first->second;
    if (part.shards != one.shards) {
      return refuse(fmt::format("shards of {} and of {} are no one run", one.shards, part.shards));
    }
    if (part.session != one.session) return refuse("the shards judged different sessions");
    if (part.renderer != one.renderer) {
      return refuse(fmt::format("the shards were drawn by different renderers: {} and {}",
                                one.renderer, part.renderer));
    }
    if (!seen[part.suite].insert(part.shard).second) {
      return refuse(fmt::format("shard {}/{} is there twice", part.shard, part.shards));
    }
  }
  for (const auto& [suite, shards] : seen) {
    for (int shard = 1; shard <= first[suite]->shards; ++shard) {
      if (shards.contains(shard)) continue;
      return Error{ErrorKind::refused,
                   fmt::format("shard {}/{} is missing", shard, first[suite]->shards), suite};
    }
  }
  return {};
}

}  // namespace

Result<SuiteReport> parseReport(std::string_view text, const std::filesystem::path& file) {
  const ReportJson root = ReportJson::parse(text, nullptr, false);
  if (root.is_discarded() || !root.is_object())
    return brokenReport(file, "it is not a JSON object");
  if (root.value("format", ReportJson()) != 1) {
    return Error{ErrorKind::unsupported, "the report has a format other than 1", file.string()};
  }
  SuiteReport report;
  report.suite = fieldOf<std::string>(root, "suite");
  report.cell = fieldOf<std::string>(root, "cell");
  report.log = fieldOf<std::string>(root, "log");
  report.renderer = fieldOf<std::string>(root, "renderer");
  report.session = fieldOf<std::string>(root, "session");
  report.made_at = fieldOf<std::string>(root, "made_at");
  report.run_command = fieldOf<std::string>(root, "run_command");
  report.approve_command = fieldOf<std::string>(root, "approve_command");
  report.notes = textsOf(root, "notes");
  if (const auto shard = root.find("shard"); shard != root.end() && shard->is_object()) {
    report.shard = fieldOf<int>(*shard, "number", 1);
    report.shards = fieldOf<int>(*shard, "of", 1);
    if (report.shard < 1 || report.shard > report.shards || report.shards > kMostShards) {
      return brokenReport(file, "its shard is none");
    }
  }
  const auto frames = root.find("frames");
  if (frames == root.end() || !frames->is_array()) return brokenReport(file, "it has no `frames`");
  for (const ReportJson& entry : *frames) {
    auto judged = frameOf(entry, report.session, file);
    if (!judged.ok()) return judged.error();
    report.frames.push_back(std::move(*judged));
  }
  return report;
}

Result<SuiteReport> readReport(const std::filesystem::path& folder) {
  const auto text = readFile(folder / kReportFileName, kMostReportBytes);
  if (!text.ok()) return text.error();
  auto report = parseReport(*text, folder / kReportFileName);
  if (!report.ok()) return report;
  for (JudgedFrame& judged : report->frames) {
    if (auto read = readPictures(folder, judged); !read) return read.error();
  }
  return report;
}

Result<SuiteReport> mergeReports(std::vector<SuiteReport> parts) {
  if (auto whole = checkShards(parts); !whole) return whole.error();
  std::ranges::stable_sort(
      parts, {}, [](const SuiteReport& part) { return std::pair(part.suite, part.shard); });
  SuiteReport merged = parts.front();
  merged.frames.clear();
  merged.notes.clear();
  merged.shard = merged.shards = 1;
  std::set<std::string> names;
  for (SuiteReport& part : parts) {
    for (std::string& note : part.notes) {
      if (std::ranges::find(merged.notes, note) == merged.notes.end()) {
        merged.notes.push_back(std::move(note));
      }
    }
    if (part.suite != parts.front().suite) merged.suite += ", " + part.suite;
    for (JudgedFrame& judged : part.frames) {
      if (!names.insert(judged.frame.name).second) {
        return Error{ErrorKind::refused,
                     fmt::format("two reports have a frame {}", judged.frame.name), part.suite};
      }
      merged.frames.push_back(std::move(judged));
    }
  }
  return merged;
}

}  // namespace rocinante
