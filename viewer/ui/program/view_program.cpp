#include "viewer/ui/program/view_program.h"

#include <utility>

#include "core/cli/load_progress.h"
#include "core/cli/program.h"
#include "viewer/ui/program/remembered.h"
#include "viewer/ui/window/window.h"

namespace rocinante {
namespace {

/// What is read within this time is shown at once, without an empty window before it.
constexpr Nanoseconds kAtOnce = std::chrono::milliseconds(60);
constexpr Nanoseconds kForever = std::chrono::hours(24);

void warnOf(const ViewContent& content) {
  for (const std::string& warning : content.warnings) cli::warn(warning);
}

/// Prints doubts about what was shown; true when there are none.
bool isBeyondDoubt(const ViewModel& model) {
  if (!model.seenDamage().empty()) {
    cli::warn(model.seenDamage().what() + "; what was shown may be older than its time says (" +
              model.seenDamage().where() + ")");
  }
  for (const std::string& doubt : model.panels.doubts) cli::warn(doubt);
  return model.seenDamage().empty() && model.panels.doubts.empty();
}

Result<ViewContent> loadNow(const ContentRequest& request) {
  if (request.empty()) return emptyContent();
  return loadContent(request, cli::loadProgress(request.named().string()));
}

/// What the window begins with: nothing if reading takes a while.
Result<ViewContent> firstContent(const ContentRequest& first, bool whole, ContentLoader& loader) {
  if (whole) return loadNow(first);
  if (first.empty()) return emptyContent();
  auto loaded = loader.waitFor(kAtOnce);
  return loaded ? std::move(*loaded) : Result<ViewContent>(emptyContent());
}

}  // namespace

Result<bool> runViewer(const ContentRequest& first, const ViewOptions& options) {
  const bool scripted = !options.script.empty();
  auto record = InputRecord::begin(options.record_input);
  if (!record.ok()) return record.error();
  // What a script or a record of input begins with is there.
  const bool whole = scripted || record->active();
  ContentLoader loader;
  std::optional<Result<ViewContent>> begun;
  if (whole) {
    begun = firstContent(first, whole, loader);
    if (!begun->ok()) return begun->error();
  } else if (!first.empty()) {
    loader.start(first);
  }
  Remembered remembered = Remembered::load(!whole && !options.fresh);
  const auto [width, height] = remembered.sizeFor(options.width, options.height);
  auto window = Window::open("Opening Rocinante", width, height, !scripted);
  if (!window.ok()) {
    // What cannot be read is the more useful answer.
    const auto loaded = loader.waitFor(kForever);
    if (loaded && !loaded->ok()) return loaded->error();
    return window.error();
  }
  if (!begun) begun = firstContent(first, whole, loader);
  if (!begun->ok()) return begun->error();

  WindowSession session{loader, {options.script, options.script_name}, std::move(*record)};
  bool beyond_doubt = true;
  auto content = std::make_unique<ViewContent>(std::move(**begun));
  while (content != nullptr) {
    warnOf(*content);
    // By its title, programs that drive a window know that what was asked for is there.
    if (!content->model->is_empty) {
      (*window)->setTitle("Rocinante: " + content->model->cell().file);
    } else {
      (*window)->setTitle(loader.busy() ? "Loading " + loader.name() + ": Rocinante" : "Rocinante");
    }
    remembered.apply(*content);
    auto next = showContent(*content, **window, options, session);
    if (!next.ok()) return next.error();
    remembered.keep(*content, **window);
    beyond_doubt = isBeyondDoubt(*content->model) && beyond_doubt;
    content = std::move(*next);
  }
  remembered.save();
  return beyond_doubt;
}

}  // namespace rocinante
