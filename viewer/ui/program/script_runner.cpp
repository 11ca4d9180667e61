#include "viewer/ui/program/script_runner.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rocinante {
namespace {

constexpr Nanoseconds kLongestAwait = std::chrono::minutes(1);

bool isSoLong(const ViewModel& model, Nanoseconds length) {
  const TimelineCursor* const cursor = model.cursor();
  return cursor != nullptr && cursor->end() - model.origin() >= length;
}

/// Whether a line of the last frame has the text; without a text, whether there was no line.
bool showsLine(const ViewModel& model, const std::string& text) {
  const std::vector<std::string>& lines = model.viewer.panels.lines;
  if (text.empty()) return lines.empty();
  return std::ranges::any_of(
      lines, [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

std::string unreached(const ViewerRequests& asked, const ViewModel& model) {
  if (asked.await_length) {
    return fmt::format("the session is not {:g}s long after a minute",
                       std::chrono::duration<double>(*asked.await_length).count());
  }
  const std::string lines =
      model.viewer.panels.lines.empty()
          ? "nothing"
          : fmt::format("\"{}\"", fmt::join(model.viewer.panels.lines, "\", \""));
  return asked.await_line->empty()
             ? fmt::format("the lines over the picture still say {} after a minute", lines)
             : fmt::format("no line over the picture says \"{}\" within a minute: they say {}",
                           *asked.await_line, lines);
}

}  // namespace

ScriptRunner::ScriptRunner(std::vector<ViewCommand> commands, std::string name)
    : commands_(std::move(commands)), name_(std::move(name)) {
  timed_ =
      std::ranges::any_of(commands_, [](const ViewCommand& one) { return one.at.has_value(); });
  now_ = timeOfNext(now_);
}

/// When the frame is drawn that the coming commands lead to.
SteadyTime ScriptRunner::timeOfNext(SteadyTime otherwise) const {
  if (frames_to_wait_ > 1) return otherwise;
  constexpr std::array<std::string_view, 5> kDrawing{"frame", "wait", "screenshot", "await",
                                                     "await-line"};
  for (std::size_t i = next_; i < commands_.size(); ++i) {
    if (commands_[i].at) return std::max(now_, SteadyTime(*commands_[i].at));
    if (std::ranges::find(kDrawing, commands_[i].name) != kDrawing.end()) break;
  }
  return otherwise;
}

Error ScriptRunner::faultAt(const ViewCommand& command, std::string what) const {
  return {ErrorKind::bad_argument, std::move(what), fmt::format("{}:{}", name_, command.line)};
}

Result<ViewerRequests> ScriptRunner::run(const ViewCommand& command, const ScriptStage& stage) {
  ViewerRequests requests;
  Status done = runCommand(command.name, command.words,
                           {stage.model, stage.now, stage.height_px, requests, &input_});
  if (!done) return faultAt(command, done.error().text());
  if (requests.evidence) return faultAt(command, "use `evidence FILE` for an evidence picture");
  if (requests.save_live) return faultAt(command, "use `save FILE` to save the live session");
  if (!requests.open.empty() && command.name == "open") {
    return faultAt(command, "use `drop FILE` to open a file");
  }
  ViewerRequests own;
  own.close = std::exchange(requests.close, false);
  own.frames = std::exchange(requests.frames, std::nullopt);
  own.screenshot = std::exchange(requests.screenshot, std::nullopt);
  own.await_length = std::exchange(requests.await_length, std::nullopt);
  own.await_line = std::exchange(requests.await_line, std::nullopt);
  own.frame_at = std::exchange(requests.frame_at, std::nullopt);
  own.await_files = std::exchange(requests.await_files, false);
  done = stage.apply(requests);
  if (!done) return faultAt(command, done.error().text());
  return own;
}

/// Whether what the command waits for is there; an error when it does not come.
Result<bool> ScriptRunner::awaited(const ViewCommand& command, const ViewerRequests& asked,
                                   const ViewModel& model) {
  // Real time: a script's own does not bring packets.
  const SteadyTime now = std::chrono::steady_clock::now();
  if (!awaits_since_) awaits_since_ = now;
  const bool reached = asked.await_length ? isSoLong(model, *asked.await_length)
                                          : showsLine(model, *asked.await_line);
  if (!reached && now - *awaits_since_ > kLongestAwait) {
    return faultAt(command, unreached(asked, model));
  }
  if (reached) awaits_since_.reset();
  return reached;
}

Status ScriptRunner::beforeFrame(const ScriptStage& stage) {
  if (frames_to_wait_ > 0 && --frames_to_wait_ > 0) return {};
  while (next_ < commands_.size()) {
    const auto left = run(commands_[next_++], stage);
    if (!left.ok()) return left.error();
    if (left->close) break;
    if (left->await_length || left->await_line) {
      const auto there = awaited(commands_[next_ - 1], *left, stage.model);
      if (!there.ok()) return there.error();
      if (*there) continue;
      --next_;
      return {};
    }
    if (left->await_files) {
      awaits_files_ = true;
      return {};
    }
    if (left->frames || left->screenshot || left->frame_at) {
      frames_to_wait_ = left->frames.value_or(left->frame_at ? 1 : 0);
      screenshot_ = left->screenshot;
      return {};
    }
    // Apply choices before the next command reads the scene.
    const auto updated = stage.model.update(stage.now);
    if (!updated.ok()) return updated.error();
    changed_ = *updated || changed_;
  }
  finished_ = true;
  return {};
}

Status ScriptRunner::afterFrame(const std::function<Picture()>& read) {
  input_.endFrame();
  now_ = timeOfNext(now_ + kFrame);
  if (!screenshot_) return {};
  const std::filesystem::path path = *std::exchange(screenshot_, std::nullopt);
  return writePng(path, read());
}

}  // namespace rocinante
