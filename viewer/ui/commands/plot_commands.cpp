#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>

#include "core/base/name_hint.h"
#include "core/kinematics/joint_values.h"
#include "core/series/derived_value.h"
#include "core/series/placed_links.h"
#include "viewer/shown/plot_scale.h"
#include "viewer/ui/commands/command_groups.h"
#include "viewer/ui/commands/script_word.h"
#include "viewer/ui/commands/study_actions.h"

namespace rocinante {
namespace {

/// A picture of the study that knows what packets state; null while a log is not read, or goes on.
auto pictureOfAll(ViewModel& model) {
  LogStudy* const study = model.study();
  auto picture = model.viewer.picture;
  if (study == nullptr) {
    picture = nullptr;
  } else if (model.study_waits) {
    picture = study->show({{}, model.cursor()->start(), model.cursor()->end(), 1, 1});
  }
  return picture != nullptr && picture->stated != nullptr ? picture : nullptr;
}

/// Refuses what no packet of the log states, with what they do state; while a log is not read, or
/// goes on, anything may come. `asked`: what was asked for, which may follow `key`.
Status checkStated(const SeriesKey& key, const SeriesKey& asked, ViewModel& model) {
  const auto picture = pictureOfAll(model);
  if (picture == nullptr) return {};
  const std::vector<SeriesKey>& stated = *picture->stated;
  if (std::ranges::find(stated, key) != stated.end()) return {};
  std::vector<std::string> texts;
  for (const SeriesKey& each : stated) {
    if (each.kind == key.kind) texts.push_back(each.text());
  }
  const std::string follows = asked == key ? "" : fmt::format(", which `{}` follows", asked.text());
  return badWord(fmt::format("no packet of the log states `{}`{}: {}", key.text(), follows,
                             whatThereIs(key.text(), {texts.begin(), texts.end()})));
}

Status checkKey(const SeriesKey& key, ViewModel& model);

/// Of what a value is derived of; a joint that follows another is never stated.
Status checkDerived(const SeriesKey& key, ViewModel& model) {
  for (const SeriesKey& stated : statedOf(key)) {
    if (Status known = checkKey(stated, model); !known) return known;
    const SeriesKey series = plotValue(stated, model.scene()).series;
    if (series != stated) {
      return badWord(
          fmt::format("`{}` follows `{}`: derive from that", stated.text(), series.text()));
    }
    const auto picture = pictureOfAll(model);
    if (picture != nullptr && picture->texts->contains(stated)) {
      return badWord(noNumberOf(key, stated));
    }
  }
  return {};
}

/// Refuses values that neither the cell nor any packet has.
Status checkKey(const SeriesKey& key, ViewModel& model) {
  if (key.kind == SeriesKey::Kind::derived) return checkDerived(key, model);
  if (key.kind == SeriesKey::Kind::signal) return checkStated(key, key, model);
  if (!key.isOfDevice()) return {};
  if (key.kind == SeriesKey::Kind::link) {
    const Status there = checkLink(model.cell(), model.state(), key);
    return there ? Status() : badWord(there.error().what);
  }
  const auto known = model.state().devices().find(key.name);
  const PosedDevice* const device = model.scene().findDevice(key.name);
  if (device == nullptr && known == model.state().devices().end()) {
    // Perhaps it is not there yet.
    const auto picture = pictureOfAll(model);
    if (picture != nullptr && std::ranges::count(*picture->stated, key) > 0) return {};
    std::vector<std::string_view> names;
    for (const PosedDevice& each : model.scene().devices) names.push_back(each.name);
    return badWord(
        fmt::format("no device is named `{}`: {}", key.name, whatThereIs(key.name, names)));
  }
  const bool is_pose = key.kind == SeriesKey::Kind::pose;
  if (device == nullptr || device->model == nullptr || device->bare || is_pose) {
    return checkStated(key, key, model);
  }
  const Model& of_device = *device->model;
  const auto joint = of_device.findJoint(key.part);
  if (of_device.findJointValue(key.part) || (joint && of_device.joints[*joint].mimic)) {
    // A joint that follows another is never stated itself.
    return checkStated(plotValue(key, &of_device).series, key, model);
  }
  const std::vector<std::string> names = positionalNames(of_device);
  return badWord(fmt::format("`{}` has no joint value `{}`: {}", key.name, key.part,
                             whatThereIs(key.part, {names.begin(), names.end()})));
}

std::string oneText(CommandWords words) { return fmt::format("{}", fmt::join(words, " ")); }

/// Whether a key that is not derived may be of a device whose name begins as one that is.
bool isNamedSo(const SeriesKey& key, const ViewModel& model) {
  return model.scene().findDevice(key.name) != nullptr ||
         model.state().findDevice(key.name) != nullptr || model.viewer.plots.find(key) != nullptr;
}

Result<SeriesKey> seriesKeyOf(const std::string& word, const ViewModel& model) {
  auto key = parseSeriesKey(word);
  const std::string fault = derivationFault(word);
  if (!fault.empty() && !(key && isNamedSo(*key, model))) return badWord(fault);
  if (key) return std::move(*key);
  return badWord(fmt::format(
      "`{}` is not DEVICE.JOINT, DEVICE:x (or y z qx qy qz qw), DEVICE/LINK:x [in PATH], "
      "signal PATH NAME, d/dt VALUE, mean SECONDS VALUE, VALUE - VALUE, "
      "VALUE over VALUE, rate, loss, rate/SOURCE or loss/SOURCE",
      word));
}

/// The two of `VALUE over VALUE`, y and x; nothing for anything else.
Result<std::optional<std::pair<SeriesKey, SeriesKey>>> pathKeysOf(const std::string& word,
                                                                  const ViewModel& model) {
  const auto texts = parsePath(word);
  if (!texts) return std::optional<std::pair<SeriesKey, SeriesKey>>();
  auto y = seriesKeyOf(texts->first, model);
  if (!y) return y.error();
  auto x = seriesKeyOf(texts->second, model);
  if (!x) return x.error();
  return std::optional(std::pair(*std::move(y), *std::move(x)));
}

/// Refuses what no x-y plot can have.
Status checkPathKey(const SeriesKey& key, ViewModel& model) {
  if (!key.isValue()) {
    return badWord(
        fmt::format("`{}` counts packets: one value is plotted over another, such as "
                    "joints, poses, links and signals",
                    key.text()));
  }
  if (Status known = checkKey(key, model); !known) return known;
  const auto picture = pictureOfAll(model);
  if (picture == nullptr || !picture->texts->contains(key)) return {};
  return badWord(fmt::format("`{}` is a text, and has no place on an axis", key.text()));
}

Status plotPath(const SeriesKey& y, const SeriesKey& x, ViewModel& model) {
  for (const SeriesKey& key : {y, x}) {
    if (Status may = checkPathKey(key, model); !may) return may;
  }
  if (model.viewer.plots.addPath(y, x)) return {};
  return badWord(fmt::format("{} values are plotted over others, and there is no room for more",
                             PlotBoard::kMaxPaths));
}

Status plotValueOf(CommandWords words, const CommandStage& stage) {
  const auto path = pathKeysOf(oneText(words), stage.model);
  if (!path.ok()) return path.error();
  if (*path) return plotPath((*path)->first, (*path)->second, stage.model);
  const auto key = seriesKeyOf(oneText(words), stage.model);
  if (!key) return key.error();
  if (Status known = checkKey(*key, stage.model); !known) return known;
  if (stage.model.viewer.plots.add(*key)) return {};
  return badWord(
      fmt::format("{} curves are plotted, and there is no room for more", PlotBoard::kMaxCurves));
}

Status unplotValue(CommandWords words, const CommandStage& stage) {
  PlotBoard& plots = stage.model.viewer.plots;
  if (words[0] == "all") {
    plots.clear();
    return {};
  }
  const auto path = pathKeysOf(oneText(words), stage.model);
  if (!path.ok()) return path.error();
  if (*path) {
    if (plots.removePath((*path)->first, (*path)->second)) return {};
    return badWord(fmt::format("`{}` is not plotted", oneText(words)));
  }
  const auto key = seriesKeyOf(oneText(words), stage.model);
  if (!key) return key.error();
  if (plots.find(*key) == nullptr) return badWord(fmt::format("`{}` is not plotted", key->text()));
  plots.remove(*key);
  return {};
}

Status setPlots(CommandWords words, const CommandStage& stage) {
  const auto on = switched(words, !stage.model.viewer.plots.hidden);
  if (!on.ok()) return on.error();
  stage.model.viewer.plots.hidden = !*on;
  return {};
}

Status writeTable(CommandWords words, const CommandStage& stage) {
  if (Status asked = writePlotted(stage.model, words[0]); !asked) return asked;
  const auto written = stage.model.study()->takeTable();
  return written && !written->ok() ? Status(written->error()) : Status();
}

Status setFindings(CommandWords words, const CommandStage& stage) {
  ViewModel& model = stage.model;
  const auto on = switched(words, model.viewer.findings_wanted);
  if (!on.ok()) return on.error();
  model.viewer.findings_wanted = *on;
  if (!*on || model.study_delayed) return {};
  // The study of the log comes first; a script has both at once.
  model.viewer.picture =
      model.study()->show({{}, model.cursor()->start(), model.cursor()->end(), 1, 1});
  model.findings();
  return {};
}

Status goToFinding(CommandWords words, const CommandStage& stage) {
  const std::string& word = words[0];
  std::size_t number = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
  const FindingsStudy* const judged = stage.model.findings();
  const CheckReport* const report = judged == nullptr ? nullptr : judged->report();
  if (report == nullptr) return badWord("`finding` needs `findings on` first");
  if (fault != std::errc{} || end != word.data() + word.size() || number == 0 ||
      number > report->findings.size()) {
    return badWord(
        fmt::format("`{}` is not the number of a finding, 1 to {}", word, report->findings.size()));
  }
  showFinding(stage.model, *stage.model.cursor(), number, stage.now);
  return {};
}

constexpr const char* kNoneBeside =
    "there is no session beside (`beside FILE`, or view --beside LOG)";

/// A log can be shown beside what is shown.
bool takesBeside(const ViewModel& model) { return model.session() != nullptr && !model.isLive(); }

Status setBeside(CommandWords words, const CommandStage& stage) {
  ViewModel& model = stage.model;
  const bool is_file =
      !words.empty() && words[0] != "on" && words[0] != "off" && words[0] != "none";
  if (is_file) {
    const auto file = textOfWord(words[0]);
    if (!file.ok()) return file.error();
    stage.requests.beside = BesideWish{*file, fmt::format("{}", fmt::join(words.subspan(1), " "))};
    stage.requests.await_files = true;
    return {};
  }
  if (words.size() > 1) return badWord(fmt::format("`beside {}` takes no other word", words[0]));
  if (words.empty() && model.beside() == nullptr && takesBeside(model)) {
    std::error_code ignored;
    model.viewer.panels.open.openBeside(std::filesystem::current_path(ignored));
    return {};
  }
  const bool ends = !words.empty() && words[0] == "none";
  const bool comes = model.viewer.panels.open.beside_comes;
  if (model.beside() == nullptr && !(ends && comes)) return badWord(kNoneBeside);
  if (ends) {
    stage.requests.beside.emplace();
    return {};
  }
  const auto on = switched(words, model.beside_shown);
  if (!on.ok()) return on.error();
  model.beside_shown = *on;
  return {};
}

/// Says how far the two are apart there, too.
Status goToLargestParting(const PartingStudy& partings, const CommandStage& stage) {
  const auto largest = partings.largest();
  if (!largest && !partings.fault().empty()) return badWord(partings.fault());
  if (!largest) {
    stage.requests.fault =
        partings.isFinished() ? "the two are nowhere apart" : "the two are still being compared";
    return {};
  }
  stage.model.cursor()->seek(largest->at, stage.now);
  stage.model.viewer.time_view.follow(largest->at);
  stage.requests.notice = "the largest difference: " + largest->what;
  return {};
}

Status goToParting(CommandWords words, const CommandStage& stage) {
  const bool to_largest = words[0] == "largest";
  const auto next = isNext(words[0]);
  if (!to_largest && !next.ok()) {
    return badWord(fmt::format("`{}` is neither next, previous nor largest", words[0]));
  }
  ViewModel& model = stage.model;
  const PartingStudy* const partings = model.partings();
  if (partings == nullptr) return badWord(kNoneBeside);
  if (to_largest) return goToLargestParting(*partings, stage);
  TimelineCursor& cursor = *model.cursor();
  if (const auto moment = partings->beside(cursor.position(stage.now), *next)) {
    cursor.seek(*moment, stage.now);
    model.viewer.time_view.follow(*moment);
  } else if (!partings->fault().empty()) {
    return badWord(partings->fault());
  } else if (!stage.model.study_waits) {
    stage.requests.fault =
        fmt::format("the two do not part {} this moment{}", *next ? "after" : "before",
                    partings->isFinished() ? "" : ", as far as is known yet");
  }
  return {};
}

bool hasBeside(const ViewModel& model) { return model.beside() != nullptr; }

}  // namespace

std::vector<Command> plotCommands() {
  std::vector<Command> commands{
      {.name = "plot",
       .arguments = "VALUE...",
       .means = "a curve: DEVICE.JOINT, DEVICE:x, DEVICE/LINK:x [in PATH], signal PATH NAME, "
                "d/dt VALUE, mean SECONDS VALUE, VALUE - VALUE, rate, loss, rate/SOURCE; "
                "VALUE over VALUE: x-y",
       .run = plotValueOf},
      {.name = "unplot",
       .arguments = "all|VALUE...",
       .means = "remove a curve, or all",
       .run = unplotValue},
      {.name = "plots",
       .arguments = "[on|off]",
       .means = "plots on or off",
       .run = setPlots,
       .shortcuts = {{"P", "", ""}}},
      {.name = "table",
       .arguments = "FILE",
       .means = "what the plots show, as CSV",
       .run = writeTable},
      {.name = "findings",
       .arguments = "[on|off]",
       .means = "judge the log in the background, as `check`",
       .run = setFindings},
      {.name = "finding",
       .arguments = "N",
       .means = "go to a finding, by its number",
       .run = goToFinding},
      {.name = "beside",
       .arguments = "[on|off|none|FILE] [HOW...]",
       .means = "another log beside the shown one, aligned as --align HOW; its ghosts and curves; "
                "none: end it",
       .run = setBeside,
       .shortcuts = {{"Y", "", "the session beside: ghosts and curves; or choose one"}},
       .offered = takesBeside,
       .choices =
           [](const ViewModel& model) {
             return hasBeside(model) ? std::vector<std::string>{"none"}
                                     : std::vector<std::string>();
           }},
      {.name = "parting",
       .arguments = "next|previous|largest",
       .means = "where the two sessions begin to be apart, or differ most",
       .run = goToParting,
       .shortcuts = {{"K", "next", "the next moment at which the two sessions part"},
                     {"shift+K", "previous", "the moment before at which they part"},
                     {"ctrl+K", "largest", "where the two sessions differ most, and by how much"}},
       .offered = hasBeside},
  };
  for (Command& command : commands) {
    command.group = CommandGroup::time;
    command.needs_log = true;
  }
  return commands;
}

}  // namespace rocinante
