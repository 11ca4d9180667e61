#include "golden/run/fact_recorder.h"

#include <algorithm>
#include <utility>

#include "core/packet/item_text.h"
#include "golden/run/drawing_shape.h"

namespace rocinante {
namespace {

std::string pathText(const Path& path) {
  return path.first + (path.second.empty() ? "" : "/" + path.second);
}

}  // namespace

void FactRecorder::set(const std::string& name, LogTime time, std::string text,
                       std::vector<double> shape) {
  auto& changes = facts_[name];
  seen_.push_back(&changes);
  if (!changes.empty() && changes.back().text == text && changes.back().shape == shape) return;
  changes.push_back({time, std::move(text), std::move(shape), is_restated_});
}

void FactRecorder::note(const SessionState& state, LogTime time, bool is_restated) {
  is_restated_ = is_restated;
  seen_.clear();
  for (const auto& [path, item] : state.visibility()) {
    if (item.value.kind == Visibility::Kind::by_default) continue;
    set("visibility of " + pathText(path), time, visibilityText(path, item.value));
  }
  for (const auto& [path, item] : state.colors()) {
    if (!item.value.rgba) continue;
    set("color of " + pathText(path), time, colorText(path, item.value));
  }
  for (const auto& [name, said] : state.devices()) {
    if (said.presence) {
      set("presence of " + name, time, presenceText(name, said.presence->value));
    }
    if (said.pose && !said.pose->value.carrier.first.empty()) {
      set("carrier of " + name, time, "in " + pathText(said.pose->value.carrier));
    }
  }
  for (const auto& [key, drawing] : state.drawings()) {
    set("drawing/" + key.first + "/" + key.second, time, drawingStyle(drawing),
        drawingShape(drawing));
  }
  for (auto& [name, changes] : facts_) {
    if (changes.back().text.empty()) continue;
    if (std::ranges::find(seen_, &changes) == seen_.end())
      changes.push_back({time, "", {}, is_restated});
  }
}

}  // namespace rocinante
