#include "viewer/ui/program/remembered.h"

#include <tuple>

#include "core/cli/program.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr int kUsualWidth = 1280;
constexpr int kUsualHeight = 720;

fs::path whole(const fs::path& path) {
  std::error_code ignored;
  return path.empty() ? path : fs::absolute(path, ignored).lexically_normal();
}

/// By what the places of panels are remembered; empty: they are not.
fs::path namesPanels(const ContentRequest& request) {
  return whole(request.cell.empty() ? request.log : request.cell);
}

}  // namespace

Remembered Remembered::load(bool wanted) {
  Remembered remembered;
  if (!wanted) return remembered;
  remembered.file_ = ViewMemory::fileOfUser();
  auto memory = ViewMemory::load(remembered.file_);
  if (memory.ok()) {
    remembered.memory_ = std::move(*memory);
  } else {
    // Somebody wrote it by hand, perhaps: it is theirs to mend.
    remembered.file_.clear();
    cli::warn("nothing is remembered: " + memory.error().text());
  }
  return remembered;
}

std::pair<int, int> Remembered::sizeFor(int width, int height) const {
  if (width > 0) return {width, height};
  if (memory_.width > 0) return {memory_.width, memory_.height};
  return {kUsualWidth, kUsualHeight};
}

void Remembered::apply(ViewContent& content) {
  ViewModel& model = *content.model;
  model.viewer.panels.is_light = isLight();
  model.viewer.panels.wall_clock = memory_.wall_clock;
  if (file_.empty()) return;
  model.viewer.panels.open.recent = memory_.recent;
  if (const auto* panels = memory_.panelsOf(namesPanels(content.request))) {
    model.viewer.panels.places.places = *panels;
  }
  if (model.viewer.is_empty || content.request.named().empty()) return;
  const RecentContent now{whole(content.request.cell), whole(content.request.log)};
  memory_.shown(now);
  shown_.push_back(now);
}

void Remembered::keep(const ViewContent& content, const Window& window) {
  const ViewModel& model = *content.model;
  memory_.theme = model.viewer.panels.is_light ? Theme::light : Theme::dark;
  memory_.wall_clock = model.viewer.panels.wall_clock;
  std::tie(memory_.width, memory_.height) = window.size();
  const fs::path named = namesPanels(content.request);
  if (!model.viewer.is_empty && !named.empty()) {
    memory_.keepPanels(named, model.viewer.panels.places.places);
  }
}

void Remembered::save() const {
  if (file_.empty()) return;
  ViewMemory now = memory_;
  if (auto other = ViewMemory::load(file_); other.ok()) {
    now.recent = std::move(other->recent);
    for (const RecentContent& one : shown_) now.shown(one);
  }
  if (const Status saved = now.save(file_); !saved) {
    cli::warn("the window's size, theme and panels are not remembered: " + saved.error().text());
  }
}

}  // namespace rocinante
