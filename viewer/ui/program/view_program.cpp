#include "viewer/ui/program/view_program.h"

#include <chrono>
#include <optional>
#include <utility>

#include "core/cli/load_progress.h"
#include "core/cli/program.h"
#include "viewer/ui/model/applied_layout.h"
#include "viewer/ui/program/first_panel.h"
#include "viewer/ui/program/remembered.h"
#include "viewer/ui/window/window.h"

namespace rocinante {
namespace {

/// What is read within this time is shown without an empty scene before it, which takes about as
/// long to make. Until then the window says what is being read, and how far.
constexpr Nanoseconds kAtOnce = std::chrono::seconds(1);
constexpr Nanoseconds kPanelChanges = std::chrono::milliseconds(100);
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
  for (const std::string& doubt : model.viewer.panels.doubts) cli::warn(doubt);
  return model.seenDamage().empty() && model.viewer.panels.doubts.empty();
}

/// What the layout has and this content has not is said over the picture. True.
bool useLayout(const ViewOptions& options, const ScriptRunner& script, ViewContent& content) {
  if (!options.layout) return true;
  // Its devices are known then. A live session counts from here, by the clock of its frames.
  const bool is_scripted = !options.script.empty();
  static_cast<void>(content.model->update(
      is_scripted ? script.now() : SteadyTime(std::chrono::steady_clock::now())));
  const std::vector<std::string> left_out = applyLayout(*options.layout, *content.model);
  noteLeftOut("the layout", left_out, *content.model);
  for (const std::string& each : left_out) cli::warn("the layout: " + each);
  return true;
}

Result<ViewContent> loadNow(const ContentRequest& request) {
  if (request.empty()) return emptyContent();
  return loadContent(
      request,
      cli::loadProgress(request.named().empty() ? request.title() : request.named().string()));
}

/// Shows what is being read, before anything else is made, until it is there or takes a while:
/// empty then. `painter`: that of the window from now on.
Result<std::optional<ViewContent>> showLoading(Window& window, ContentLoader& loader,
                                               const FirstPanelLook& look,
                                               const ViewOptions& options,
                                               std::optional<ImguiPainter>& painter) {
  auto journal = FrameJournal::open(options.frame_times);
  if (!journal.ok()) return journal.error();
  FirstPanel panel(window, look, *journal);
  const SteadyTime began = std::chrono::steady_clock::now();
  std::optional<Result<ViewContent>> loaded;
  do {
    if (Status shown = panel.show({loader.name(), loader.progress()}); !shown) return shown.error();
    loaded = loader.waitFor(kPanelChanges);
  } while (!loaded && !cli::stopRequested() && std::chrono::steady_clock::now() < began + kAtOnce);
  painter = panel.takePainter();
  if (!loaded) return std::optional<ViewContent>();
  if (!loaded->ok()) return loaded->error();
  return std::optional(std::move(**loaded));
}

}  // namespace

Result<bool> runViewer(const ContentRequest& first, const ViewOptions& options) {
  const bool scripted = !options.script.empty();
  auto record = InputRecord::begin(options.record_input);
  if (!record.ok()) return record.error();
  // What a script or a record of input begins with is there.
  const bool whole = scripted || record->active();
  ContentLoader loader;
  std::optional<ViewContent> begun;
  if (whole) {
    auto loaded = loadNow(first);
    if (!loaded.ok()) return loaded.error();
    begun = std::move(*loaded);
  } else if (!first.empty()) {
    loader.start(first);
  }
  Remembered remembered = Remembered::load(!whole && !options.fresh);
  const auto [width, height] = remembered.sizeFor(options.width, options.height);
  auto window = Window::open("Opening Rocinante", width, height, !scripted);
  const auto failed = [&](const Error& error) {
    // What cannot be read is the more useful answer.
    const auto loaded = loader.waitFor(kForever);
    return loaded && !loaded->ok() ? loaded->error() : error;
  };
  if (!window.ok()) return failed(window.error());
  std::optional<ImguiPainter> painter;
  if (loader.busy()) {
    auto loaded =
        showLoading(**window, loader, {options.scale, remembered.isLight()}, options, painter);
    if (!loaded.ok()) return failed(loaded.error());
    begun = std::move(*loaded);
  }
  if (!begun) begun = emptyContent();

  WindowSession session{
      loader, {options.script, options.script_name}, std::move(*record), std::move(painter)};
  bool beyond_doubt = true, has_layout = false;
  auto content = std::make_unique<ViewContent>(std::move(*begun));
  while (content != nullptr) {
    warnOf(*content);
    // By its title, programs that drive a window know that what was asked for is there.
    if (!content->model->viewer.is_empty) {
      (*window)->setTitle("Rocinante: " + content->model->cell().file);
    } else {
      (*window)->setTitle(loader.busy() ? "Loading " + loader.name() + ": Rocinante" : "Rocinante");
    }
    remembered.apply(*content);
    if (!content->model->viewer.is_empty && !has_layout) {
      has_layout = useLayout(options, session.script, *content);
    }
    auto next = showContent(*content, **window, options, session);
    if (!next.ok()) return next.error();
    remembered.keep(*content, **window);
    beyond_doubt = isBeyondDoubt(*content->model) && beyond_doubt;
    // Said once, though it may come back.
    content->warnings.clear();
    content->model->viewer.panels.doubts.clear();
    if (*next != nullptr) session.left.leave(std::move(content), **next);
    content = std::move(*next);
  }
  remembered.save();
  return beyond_doubt;
}

}  // namespace rocinante
