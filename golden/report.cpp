#include "golden/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/plain_text.h"

namespace rocinante {
namespace {

using Json = nlohmann::ordered_json;

Json frameJson(const JudgedFrame& judged) {
  const Comparison& found = judged.comparison;
  Json frame = {
      {"name", judged.frame.name},
      {"verdict", nameOf(judged.verdict)},
      {"rule", judged.rule},
      {"key", judged.key},
      {"pixels", judged.pixels},
      {"inputs", judged.inputs},
      {"tolerance", judged.tolerance.name},
      {"max", found.max},
      {"worst_tile_mean", found.worst_tile_mean},
      {"pixels_over",
       {{"1", found.over_1}, {"2", found.over_2}, {"8", found.over_8}, {"32", found.over_32}}},
      {"render_ms", judged.render_ms},
      {"judge_ms", judged.judge_ms}};
  if (judged.frame.time) frame["log_time_ns"] = judged.frame.time->time_since_epoch().count();
  if (judged.golden) {
    frame["golden"] = {{"picture", judged.golden->picture},
                       {"pixels", judged.golden->pixels},
                       {"inputs_equal", judged.golden->inputs == judged.inputs},
                       {"session_equal", judged.golden->session == judged.session}};
  }
  return frame;
}

Status writePictures(const JudgedFrame& judged, const std::filesystem::path& folder) {
  if (judged.verdict == FrameVerdict::same || !judged.drawn) return {};
  const std::string stem = (folder / judged.frame.name).string();
  if (auto status = writePng(stem + ".frame.png", *judged.drawn); !status) return status;
  if (!judged.accepted) return {};
  if (auto status = writePng(stem + ".golden.png", *judged.accepted); !status) return status;
  if (judged.accepted->width != judged.drawn->width ||
      judged.accepted->height != judged.drawn->height) {
    return {};
  }
  return writePng(stem + ".difference.png", differencePicture(*judged.drawn, *judged.accepted));
}

}  // namespace

std::size_t SuiteReport::count(FrameVerdict verdict) const {
  return static_cast<std::size_t>(
      std::ranges::count(frames, verdict, [](const JudgedFrame& frame) { return frame.verdict; }));
}

Verdict SuiteReport::verdict() const {
  if (!frames.empty() && count(FrameVerdict::same) == frames.size()) return Verdict::same;
  const bool no = count(FrameVerdict::different) + count(FrameVerdict::missing) +
                      count(FrameVerdict::unstable) >
                  0;
  return no ? Verdict::different : Verdict::incomparable;
}

std::string reportJson(const SuiteReport& report) {
  Json root;
  root["format"] = 1;
  root["verdict"] = nameOf(report.verdict());
  root["suite"] = report.suite;
  root["cell"] = report.cell;
  root["log"] = report.log;
  root["session"] = report.session;
  root["renderer"] = report.renderer;
  root["counts"] = {{"same", report.count(FrameVerdict::same)},
                    {"different", report.count(FrameVerdict::different)},
                    {"missing", report.count(FrameVerdict::missing)},
                    {"unstable", report.count(FrameVerdict::unstable)},
                    {"incomparable", report.count(FrameVerdict::incomparable)}};
  root["frames"] = Json::array();
  for (const JudgedFrame& judged : report.frames) root["frames"].push_back(frameJson(judged));
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string reportJunit(const SuiteReport& report) {
  const std::size_t errors = report.count(FrameVerdict::incomparable);
  const std::size_t failures = report.frames.size() - errors - report.count(FrameVerdict::same);
  double seconds = 0;
  std::string cases;
  for (const JudgedFrame& judged : report.frames) {
    const double took = (judged.render_ms + judged.judge_ms) / 1000;
    seconds += took;
    cases += fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n",
                         xmlText(report.suite), xmlText(judged.frame.name), took);
    if (judged.verdict != FrameVerdict::same) {
      cases += fmt::format("    <{0} message=\"{1}: {2}\"/>\n",
                           judged.verdict == FrameVerdict::incomparable ? "error" : "failure",
                           nameOf(judged.verdict), xmlText(judged.rule));
    }
    cases += "  </testcase>\n";
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n{}"
      "</testsuite>\n",
      xmlText(report.suite), report.frames.size(), failures, errors, seconds, cases);
}

Status writeReport(const SuiteReport& report, const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault) {
    return Error{ErrorKind::unreadable, "cannot create: " + fault.message(), folder.string()};
  }
  for (const JudgedFrame& judged : report.frames) {
    if (auto status = writePictures(judged, folder); !status) return status;
  }
  return writeFileWhole(folder / "index.html", bytesOf(reportHtml(report)), true);
}

}  // namespace rocinante
