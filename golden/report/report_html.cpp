#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/base64.h"
#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "golden/report/cause_groups.h"
#include "golden/report/report_formats.h"
#include "golden/report/report_page.h"
#include "golden/report/report_pictures.h"
#include "golden/report/report_runs.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

using Json = nlohmann::ordered_json;

/// The pictures of the page, each stored once.
class PagePictures {
 public:
  /// Returns the picture's number in the page.
  std::size_t add(const Picture& picture) {
    const auto [found, is_new] = number_.try_emplace(pictureXxh3(picture), number_.size());
    if (is_new) {
      html_ += fmt::format("<script type=\"text/plain\" id=\"picture-{}\">{}</script>\n",
                           found->second, base64Of(encodePng(picture)));
    }
    return found->second;
  }
  const std::string& html() const { return html_; }

 private:
  std::map<std::string, std::size_t> number_;
  std::string html_;
};

Json picturesJson(const JudgedFrame& judged, PagePictures& pictures) {
  Json json = Json::object();
  const Picture* small = judged.thumbnail  ? &*judged.thumbnail
                         : judged.drawn    ? &*judged.drawn
                         : judged.accepted ? &*judged.accepted
                                           : nullptr;
  if (small != nullptr) json["thumbnail"] = pictures.add(listPicture(*small));
  if (isFine(judged.verdict) && !judged.why) return json;
  if (judged.drawn) json["frame"] = pictures.add(*judged.drawn);
  if (judged.accepted) json["golden"] = pictures.add(*judged.accepted);
  if (judged.unmasked) json["compared"] = pictures.add(*judged.unmasked);
  if (judged.why && !judged.why->blame.mask.rgba.empty()) {
    json["mask"] = pictures.add(judged.why->blame.mask);
  }
  return json;
}

Json whyJson(const FrameWhy& why) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < std::min(why.blame.changes.size(), Blame::kMaxRows); ++i) {
    const LinkChange& change = why.blame.changes[i];
    rows.push_back({{"row", i + 1},
                    {"name", nameText(change)},
                    {"pixels", change.pixels},
                    {"what", whatText(change)}});
  }
  Json state = Json::array();
  for (const StateChange& change : why.state) state.push_back(change.text);
  return {{"basis", sentenceOf(why.basis)},
          {"differing", why.blame.differing},
          {"rows", rows},
          {"state", state},
          {"files", why.files}};
}

Json factsJson(const JudgedFrame& judged) {
  Json facts = Json::array();
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) facts.push_back({name, value});
  };
  add("expectation", judged.expectation);
  std::string masks;
  for (const PictureMask::Part& mask : judged.masks) {
    masks += fmt::format("{}{}: {}", masks.empty() ? "" : "; ", mask.name,
                         countText(static_cast<std::uint64_t>(mask.pixels), "pixel"));
  }
  add("masked", masks);
  if (!judged.golden) return facts;
  const AcceptedPicture& golden = *judged.golden;
  add("golden", fmt::format("{}, accepted by {} on {}: {}", golden.picture, golden.accepted_by,
                            golden.accepted_at, golden.reason));
  if (golden.key != judged.key) add("golden of", golden.key);
  if (!isFine(judged.verdict)) {
    add("drawn from", golden.inputs == judged.inputs
                          ? "same textures, glyphs and geometry as the golden"
                          : "different textures, glyphs or geometry");
    if (golden.session != judged.session) {
      add("session", "a different recording");
    } else if (golden.decoded != judged.decoded) {
      add("session", "the same recording, decoded differently");
    }
  }
  return facts;
}

std::string toleranceText(const JudgedFrame& judged) {
  const Tolerance& tolerance = judged.tolerance;
  std::string text = tolerance.name;
  if (tolerance.limitsPixels()) {
    text += fmt::format(": {} of 255 in {} % of the pixels", tolerance.level, tolerance.percent);
  } else if (!tolerance.exact) {
    text += fmt::format(": tile mean {:.2f}, {} of a tile over 32", tolerance.tile_mean,
                        countText(static_cast<std::uint64_t>(tolerance.tile_over), "pixel"));
  }
  return judged.limit_from.empty() ? text : text + ", from " + judged.limit_from;
}

Json pageFrameJson(const SuiteReport& report, const JudgedFrame& judged, const std::string& cause,
                   PagePictures& pictures) {
  const SuiteFrame& frame = judged.frame;
  Json json = {{"name", frame.name},
               {"verdict", nameOf(judged.verdict)},
               {"rule", judged.rule},
               {"tags", frame.tags},
               {"camera", frame.camera},
               {"key", judged.key},
               {"pixels", judged.pixels},
               {"inputs", judged.inputs},
               {"tolerance", toleranceText(judged)},
               {"facts", factsJson(judged)},
               {"pictures", picturesJson(judged, pictures)},
               {"can_approve", canApprove(judged) && judged.lacks.empty()}};
  if (frame.time && !report.log.empty()) {
    json["moment"] = rfc3339Text(WallTime(frame.time->time_since_epoch()));
  }
  const Comparison& found = judged.comparison;
  if (found.differing > 0) {
    json["figures"] = {{"differing", found.differing},
                       {"over", {found.over_1, found.over_2, found.over_8, found.over_32}},
                       {"max", found.max},
                       {"x", found.worst_x},
                       {"y", found.worst_y},
                       {"tile_mean", found.worst_tile_mean},
                       {"tile_over", found.worst_tile_over}};
  }
  if (judged.why) json["why"] = whyJson(*judged.why);
  if (!cause.empty()) json["cause"] = cause;
  if (!judged.page.empty()) json["page"] = judged.page;
  const auto add = [&](const char* key, const std::string& own, const std::string& of_all) {
    const std::string& command = own.empty() ? of_all : own;
    if (!command.empty()) json[key] = command + " " + shellWord(frame.name);
  };
  add("run", judged.run_command, report.run_one_command);
  add("approve", judged.approve_command, report.approve_one_command);
  return json;
}

/// Pictures by their numbers in the page.
Json pageRunsJson(const SuiteReport& report, PagePictures& pictures) {
  Json runs = runsJson(report.runs);
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const JudgedRun& run = report.runs[i];
    runs[i]["can_approve"] = canApproveRun(run);
    for (std::size_t k = 0; k < run.pictures.size(); ++k) {
      runs[i]["pictures"][k]["picture"] = pictures.add(run.pictures[k].picture);
    }
  }
  return runs;
}

Json environmentJson(const SuiteReport& report) {
  Json entries = Json::array();
  const auto add = [&](const std::string& name, const std::string& value, bool command = false) {
    if (!value.empty()) entries.push_back({{"name", name}, {"value", value}, {"command", command}});
  };
  add("suite", report.suite);
  add("cell", report.cell);
  add("log", report.log);
  add("session", report.session);
  add("decoded", report.decoded);
  add("renderer", report.renderer);
  add("made at", report.made_at);
  for (const auto& [name, value] : report.environment) add(name, value);
  add("run again", report.run_command, true);
  add("approve", report.approve_command, true);
  return entries;
}

template <class Judged>
Json countsJson(const std::vector<Judged>& judged) {
  Json counts = Json::object();
  for (const FrameVerdict verdict : kFrameVerdicts) {
    counts[std::string(nameOf(verdict))] = std::ranges::count(judged, verdict, &Judged::verdict);
  }
  return counts;
}

/// Verdicts that a person must look at are shown first.
Json shownFirst(const SuiteReport& report) {
  Json verdicts = Json::array();
  for (const FrameVerdict verdict : kFrameVerdicts) {
    if (!isFine(verdict) && report.count(verdict) > 0) verdicts.push_back(nameOf(verdict));
  }
  return verdicts;
}

/// Failures as text, for browsers without scripts.
std::string plainHtml(const SuiteReport& report) {
  std::string html =
      fmt::format("<p>{}: {}.</p>\n", nameOf(report.verdict()), asAcceptedText(report));
  const std::string cause = firstSentence(report);
  if (!cause.empty()) html = fmt::format("<p>{}</p>\n", xmlText(cause)) + html;
  html += "<ul>\n";
  for (const JudgedFrame& judged : report.frames) {
    if (isFine(judged.verdict)) continue;
    html += fmt::format("<li>{}: <b>{}</b>, {}</li>\n", xmlText(judged.frame.name),
                        nameOf(judged.verdict), xmlText(judged.rule));
  }
  for (const JudgedRun& run : report.runs) {
    html += fmt::format("<li>run {}: <b>{}</b>, {}</li>\n", xmlText(run.name), nameOf(run.verdict),
                        xmlText(run.rule));
  }
  return html + "</ul>\n";
}

/// JSON inside a script element: nothing in it may look like markup.
std::string scriptJson(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

/// The page with each mark replaced by its text.
std::string filledPage(const std::vector<std::pair<std::string_view, std::string_view>>& texts) {
  std::string page;
  std::string_view rest = kReportPage;
  for (const auto& [mark, text] : texts) {
    const std::size_t at = rest.find(mark);
    page += rest.substr(0, at);
    page += text;
    rest.remove_prefix(at + mark.size());
  }
  return page.append(rest);
}

}  // namespace

std::string reportHtml(const SuiteReport& report) {
  PagePictures pictures;
  Json frames = Json::array();
  for (const CauseGroup& group : causeGroups(report.frames)) {
    for (const JudgedFrame* const judged : group.frames) {
      frames.push_back(pageFrameJson(report, *judged, group.sentence, pictures));
    }
  }
  for (const JudgedFrame& judged : report.frames) {
    if (isFine(judged.verdict)) frames.push_back(pageFrameJson(report, judged, "", pictures));
  }
  const Json root = {
      {"verdict", nameOf(report.verdict())},
      {"title", report.suite},
      {"cause", firstSentence(report)},
      {"counts", countsJson(report.frames)},
      {"run_counts", countsJson(report.runs)},
      {"environment", environmentJson(report)},
      {"notes", report.notes},
      {"show_first", shownFirst(report)},
      {"approve_from",
       report.approve_from_command.empty() ? Json(nullptr) : Json(report.approve_from_command)},
      {"frames", frames},
      {"runs", pageRunsJson(report, pictures)}};
  const std::string title = fmt::format("{}: {}", nameOf(report.verdict()), xmlText(report.suite));
  const std::string plain = plainHtml(report);
  const std::string data = scriptJson(root);
  return filledPage({{"<!--TITLE-->", title},
                     {"/*STYLE*/", kReportStyle},
                     {"<!--PLAIN-->", plain},
                     {"<!--DATA-->", data},
                     {"<!--PICTURES-->", pictures.html()},
                     {"/*SCRIPT*/", kReportScript}});
}

}  // namespace rocinante
