#include "viewer/ui/script_runner.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace rocinante {

Error ScriptRunner::faultAt(const ViewCommand& command, std::string what) const {
  return {ErrorKind::bad_argument, std::move(what), fmt::format("{}:{}", name_, command.line)};
}

Result<double> ScriptRunner::number(const ViewCommand& command, std::size_t word) const {
  const std::string& text = command.words[word];
  double value = 0;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || stop != text.data() + text.size() || !std::isfinite(value)) {
    return faultAt(command, fmt::format("`{}` is no number", text));
  }
  return value;
}

Status ScriptRunner::apply(const ViewCommand& command, const ScriptStage& stage) {
  ViewModel& model = stage.model;
  const std::string first = command.words.empty() ? std::string() : command.words.front();
  if (command.name == "camera") {
    model.useCamera(first);
    model.cameraView();
    return model.complaint.empty() ? Status{} : Status{faultAt(command, model.complaint)};
  }
  if (command.name == "fit") {
    model.fit(stage.visible_corners(), stage.width, stage.height);
    return {};
  }
  if (command.name == "hide" || command.name == "show") {
    if (model.setVisible(first, command.name == "show")) return {};
    return faultAt(command, fmt::format("`{}` is no DEVICE, DEVICE/LINK or layer/NAME", first));
  }
  if (command.name == "panels") {
    model.panels_shown = first != "off";
    return {};
  }
  if (command.name == "select") {
    model.selected_device = first;
    return {};
  }
  if (command.name == "orbit" || command.name == "pan" || command.name == "zoom") {
    const auto x = number(command, 0);
    if (!x.ok()) return x.error();
    if (command.name == "zoom") {
      model.holdCamera().zoom(*x);
      return {};
    }
    const auto y = number(command, 1);
    if (!y.ok()) return y.error();
    if (command.name == "pan") {
      model.holdCamera().pan(*x, *y, stage.height);
    } else {
      model.holdCamera().orbit(*x, *y, stage.height);
    }
    return {};
  }
  Transport* transport = model.transport();
  if (transport == nullptr) {
    return faultAt(command, fmt::format("`{}` needs a log", command.name));
  }
  if (command.name == "play") transport->play(stage.now);
  if (command.name == "pause") transport->pause(stage.now);
  if (command.name == "loop") transport->setLooping(first != "off");
  if (command.name == "speed" && !transport->setSpeed(first, stage.now)) {
    return faultAt(command, fmt::format("`{}` is no speed from 0.01 to 1000", first));
  }
  if (command.name == "seek") {
    const auto moment = parseSessionTime(first, model.origin(), transport->end());
    if (!moment.ok()) return faultAt(command, moment.error().text());
    transport->seek(*moment, stage.now);
  }
  return {};
}

Status ScriptRunner::beforeFrame(const ScriptStage& stage) {
  if (frames_to_wait_ > 0 && --frames_to_wait_ > 0) return {};
  while (next_ < commands_.size()) {
    const ViewCommand& command = commands_[next_++];
    if (command.name == "quit") break;
    if (command.name == "frame") {
      // Names a frame rate of the script's own: `frame N` draws N frames.
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
    // What was chosen must be there when the next command looks at the scene.
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
