#include "viewer/ui/program/script_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "viewer/detail/detail_level.h"

namespace rocinante {

Error ScriptRunner::faultAt(const ViewCommand& command, std::string what) const {
  return {ErrorKind::bad_argument, std::move(what), fmt::format("{}:{}", name_, command.line)};
}

Result<double> ScriptRunner::number(const ViewCommand& command, std::size_t word) const {
  const std::string& text = command.words[word];
  double value = 0;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || stop != text.data() + text.size() || !std::isfinite(value)) {
    return faultAt(command, fmt::format("`{}` is not a number", text));
  }
  return value;
}

/// Applies commands that change what is shown and how.
Status ScriptRunner::applyLook(const ViewCommand& command, const ScriptStage& stage) {
  ViewModel& model = stage.model;
  const std::string& first = command.words.front();
  if (command.name == "style") {
    RenderStyle style = model.style();
    Status set = setStyle(style, first, command.words[1]);
    if (set) set = model.names().check(style);
    if (!set) return faultAt(command, set.error().text());
    model.setStyle(style);
  } else if (command.name == "panels") {
    model.panels_shown = first != "off";
  } else if (command.name == "help") {
    model.help_shown = first != "off";
  } else if (command.name == "insets") {
    for (InsetChoice& inset : model.insets) inset.shown = first != "off";
  } else if (auto known = model.names().check({first}); !known) {
    return faultAt(command, known.error().text());
  } else if (command.name == "select") {
    const std::size_t slash = first.find('/');
    model.selected.device = first.substr(0, slash);
    model.selected.link = slash == std::string::npos ? "" : first.substr(slash + 1);
  } else {
    const std::optional<bool> wanted = command.name == "auto"
                                           ? std::optional<bool>()
                                           : std::optional<bool>(command.name == "show");
    if (!model.setVisible(first, wanted)) {
      return faultAt(command, fmt::format("`{}` is not DEVICE, DEVICE/LINK or layer/NAME", first));
    }
  }
  return {};
}

/// Applies commands of mouse and keyboard.
Status ScriptRunner::applyPerson(const ViewCommand& command, const ScriptStage& stage) {
  ViewModel& model = stage.model;
  if (command.name == "key") {
    const auto press = parseKey(command.words.front());
    if (!press) return faultAt(command, fmt::format("`{}` is not a key", command.words.front()));
    ViewerRequests requests;
    applyKey(model, *press, stage.now, requests);
    if (requests.evidence) return faultAt(command, "use `evidence FILE` for an evidence picture");
    stage.grant(requests);
    return {};
  }
  const auto x = number(command, 0);
  if (!x.ok()) return x.error();
  if (command.name == "zoom") {
    model.holdCamera().zoom(*x);
    return {};
  }
  const auto y = number(command, 1);
  if (!y.ok()) return y.error();
  if (command.name == "click") return stage.click({*x, *y, false});
  if (command.name == "pan") model.holdCamera().pan(*x, *y, stage.height);
  if (command.name == "orbit") model.holdCamera().orbit(*x, *y, stage.height);
  return {};
}

Status ScriptRunner::applyPlayback(const ViewCommand& command, const ScriptStage& stage) {
  TimelineCursor* cursor = stage.model.cursor();
  if (cursor == nullptr) {
    return faultAt(command, fmt::format("`{}` needs a log", command.name));
  }
  if (command.name == "play") cursor->play(stage.now);
  if (command.name == "pause") cursor->pause(stage.now);
  if (command.name == "loop") cursor->setLooping(command.words.front() != "off");
  if (command.name == "speed" && !cursor->setSpeed(command.words.front(), stage.now)) {
    return faultAt(command,
                   fmt::format("`{}` is not a speed from 0.01 to 1000", command.words.front()));
  }
  if (command.name == "seek") {
    const auto moment =
        parseSessionTime(command.words.front(), stage.model.origin(), cursor->end());
    if (!moment.ok()) return faultAt(command, moment.error().text());
    cursor->seek(*moment, stage.now);
  }
  return {};
}

Status ScriptRunner::apply(const ViewCommand& command, const ScriptStage& stage) {
  ViewModel& model = stage.model;
  if (command.name == "camera") {
    model.useCamera(command.words.front());
    model.cameraView();
    return model.complaint.empty() ? Status{} : Status{faultAt(command, model.complaint)};
  }
  if (command.name == "fit") {
    model.fit(stage.fitted_corners(), stage.width, stage.height);
    return {};
  }
  if (command.name == "detail") {
    ViewerRequests requests;
    requests.rung = parseDetailRung(command.words.front());
    if (!requests.rung) {
      return faultAt(command, fmt::format("`{}` is not a level of detail from 0 to {}",
                                          command.words.front(), kCoarsestRung));
    }
    stage.grant(requests);
    return {};
  }
  if (command.name == "evidence") {
    if (auto made = stage.make_evidence(command.words.front()); !made) {
      return faultAt(command, made.error().text());
    }
    return {};
  }
  constexpr std::array<std::string_view, 8> kLooks{"style",  "panels", "help", "insets",
                                                   "select", "hide",   "show", "auto"};
  constexpr std::array<std::string_view, 5> kPerson{"key", "click", "orbit", "pan", "zoom"};
  if (std::ranges::find(kLooks, command.name) != kLooks.end()) return applyLook(command, stage);
  if (std::ranges::find(kPerson, command.name) != kPerson.end()) {
    return applyPerson(command, stage);
  }
  return applyPlayback(command, stage);
}

Status ScriptRunner::beforeFrame(const ScriptStage& stage) {
  if (frames_to_wait_ > 0 && --frames_to_wait_ > 0) return {};
  while (next_ < commands_.size()) {
    const ViewCommand& command = commands_[next_++];
    if (command.name == "quit") break;
    if (command.name == "frame") {
      // `frame N` draws N frames.
      const auto count = number(command, 0);
      if (!count.ok()) return count.error();
      frames_to_wait_ = static_cast<int>(std::min(std::max(*count, 1.0), 1e6));
      return {};
    }
    if (command.name == "wait") {
      const auto seconds = number(command, 0);
      if (!seconds.ok()) return seconds.error();
      frames_to_wait_ = static_cast<int>(std::min(std::max(*seconds * 60, 1.0), 1e6));
      return {};
    }
    if (command.name == "screenshot") {
      screenshot_ = command.words.front();
      return {};
    }
    if (auto applied = apply(command, stage); !applied) return applied;
    // Apply choices before the next command reads the scene.
    if (auto updated = stage.model.update(stage.now); !updated.ok()) return updated.error();
  }
  finished_ = true;
  return {};
}

Status ScriptRunner::afterFrame(const std::function<Picture()>& read) {
  if (!screenshot_) return {};
  const std::filesystem::path path = *std::exchange(screenshot_, std::nullopt);
  return writePng(path, read());
}

}  // namespace rocinante
