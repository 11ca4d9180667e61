#include "viewer/ui/program/opening.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/plain_text.h"
#include "core/cli/program.h"
#include "viewer/ui/study/endpoint_survey.h"
#include "viewer/view/camera_choice.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kLongestReading = std::chrono::hours(24);

/// A camera of the cell by its name, any other viewpoint in numbers: a source's view may not be
/// there yet.
std::string viewpointNow(ViewModel& model) {
  const std::vector<CellCamera>& cameras = model.cell().cameras;
  const std::string& name = model.cameraName();
  const bool is_of_cell = std::ranges::find(cameras, name, &CellCamera::name) != cameras.end();
  return is_of_cell ? name : viewpointText(model.cameraView());
}

/// Of the paths those that a live session of the cell may have: a log's own devices are not there.
std::vector<std::string> pathsOfLive(const Cell& cell, std::vector<std::string> paths) {
  KnownNames names(cell);
  names.expectOthers();
  std::erase_if(paths, [&](const std::string& path) { return !names.check({path}).ok(); });
  return paths;
}

/// True when a port is held by this program itself.
bool isOwnPort(const Error& error) {
  return error.what.find(fmt::format("(pid {})", ::getpid())) != std::string::npos;
}

Error badArgument(std::string what) { return {ErrorKind::bad_argument, std::move(what), {}}; }

/// Both are recorded, and of the same devices of a cell.
bool areAlike(const ViewModel& shown, const ViewModel& next) {
  const bool recorded =
      shown.session() != nullptr && !shown.isLive() && next.session() != nullptr && !next.isLive();
  return recorded && !shown.cell().devices.empty() &&
         std::ranges::equal(shown.cell().devices, next.cell().devices, {}, &CellDevice::name,
                            &CellDevice::name);
}

/// What is wrong with the text of endpoints, if anything is.
std::optional<Error> unreadOf(const std::vector<std::string>& endpoints) {
  for (const std::string& endpoint : endpoints) {
    if (const Status sound = Endpoint::check(endpoint); !sound) return sound.error();
  }
  return std::nullopt;
}

constexpr const char* kWayOut = "`save` what you need, then `disconnect forget`";

Error wouldBeLost() {
  return badArgument(fmt::format("what this session kept would be deleted: {}", kWayOut));
}

/// The same of one that is not shown, which cannot be saved until it is.
Error wouldBeLostBehind() {
  return badArgument(
      fmt::format("what the session that goes on behind this kept would be deleted: `live` shows "
                  "it; {}",
                  kWayOut));
}

}  // namespace

Opening::Opening(ContentLoader& loader, LeftSessions& left, ViewContent& shown)
    : loader_(loader), left_(left), content_(shown), model_(*shown.model), shown_(shown.request) {
  tellLeft();
  if (shown_.log.empty()) return;
  std::error_code ignored;
  model_.viewer.panels.open.log = std::filesystem::absolute(shown_.log, ignored).lexically_normal();
}

Status Opening::mayBegin() const {
  if (loader_.busy()) {
    return Error{ErrorKind::refused, "wait until " + plainText(loader_.name()) + " is loaded", {}};
  }
  if (back_) return Error{ErrorKind::refused, "wait until the live session is shown", {}};
  return {};
}

Status Opening::begin() {
  if (auto may = mayBegin(); !may) return may;
  model_.viewer.panels.open.used = true;
  model_.viewer.panels.notes.clear();
  return {};
}

Status Opening::mayLeave(const ContentRequest& next) const {
  using Leaving = ContentRequest::Leaving;
  if (next.leaving == Leaving::goes_along || next.leaving == Leaving::ends) return {};
  // With a new session beside it, one that has heard nothing yet counts: by the time that the new
  // one is there, both may have heard something.
  const bool stays = next.connect.empty() ? hasHeard(model_) : model_.isLive();
  if (!stays) return {};
  if (next.leaving == Leaving::ends_unheard) return wouldBeLost();
  if (left_.size() < LeftSessions::kMost) return {};
  return Error{
      ErrorKind::refused,
      fmt::format("this window keeps {} live sessions: {}", LeftSessions::kMost + 1, kWayOut),
      {}};
}

Status Opening::open(const std::vector<std::filesystem::path>& files) {
  if (files.empty()) return {};
  if (busy() || back_) {
    model_.viewer.panels.open.used = true;
    loader_.keepForLater(files);
    return {};
  }
  if (auto begun = begin(); !begun) return begun;
  return load(files);
}

Status Opening::loadLater() {
  if (loader_.busy() || !loader_.hasLater()) return {};
  return load(loader_.takeLater());
}

Status Opening::load(const std::vector<std::filesystem::path>& files) {
  model_.viewer.panels.open.used = true;
  auto request = requestOf(files, shown_);
  if (!request.ok()) return request.error();
  if (auto may = mayLeave(*request); !may) return may;
  loader_.start(std::move(*request));
  return {};
}

Status Opening::showBeside(const BesideWish& wish) {
  bool& comes = model_.viewer.panels.open.beside_comes;
  if (wish.file.empty() && comes) {
    comes = false;
    gives_up_beside_ = true;
  } else if (auto may = mayBegin(); !may) {
    return may;
  }
  if (wish.file.empty()) {
    model_.endBeside();
    shown_.beside.clear();
    shown_.align.clear();
    content_.beside_folder.reset();
    return {};
  }
  if (model_.isLive()) {
    return badArgument("no log is shown beside a live session: `save` it, and open that");
  }
  if (model_.session() == nullptr) {
    return badArgument("a log is shown beside another one, and none is shown");
  }
  auto request = besideOf(wish.file, wish.align, shown_);
  if (!request.ok()) return request.error();
  // A cell that the log carries, if it was imported, is in what became of it.
  if (shown_.cell == shown_.log) request->cell = model_.session()->log().name();
  loader_.start(std::move(*request));
  comes = true;
  return {};
}

void Opening::offerBeside(ViewContent& next) const {
  const std::filesystem::path& log = model_.viewer.panels.open.log;
  if (!next.request.beside.empty() || next.request.log == log) return;
  if (areAlike(model_, *next.model)) next.model->viewer.panels.open.before = log;
}

std::string Opening::takeBeside(ViewContent read) {
  const std::string name = plainText(read.request.title());
  const auto added = addBeside(std::move(*read.beside), read.request, content_);
  if (!added.ok()) return name + " is not shown beside: " + added.error().text();
  if (!added->refusal.empty()) return added->refusal;
  shown_.beside = std::move(read.request.beside);
  shown_.align = std::move(read.request.align);
  model_.viewer.panels.dropNotes(PictureNote::Of::failure);
  for (const std::string& warning : added->warnings) cli::warn(warning);
  return {};
}

Status Opening::connect(const std::vector<std::string>& endpoints) {
  if (auto begun = begin(); !begun) return begun;
  unread_ = unreadOf(endpoints);
  if (unread_) return {};
  const std::string text = fmt::format("{}", fmt::join(endpoints, " "));
  if (model_.isLive() && (shown_.connect == endpoints || endpointsText(shown_) == text)) {
    return badArgument("this window listens at " + typedText(endpoints) + " already");
  }
  back_ = left_.find(endpoints);
  if (back_) return {};
  ContentRequest request = connectionOf(endpoints, shown_);
  if (auto may = mayLeave(request); !may) return may;
  if (!model_.viewer.is_empty) {
    request.hide = pathsOfLive(model_.cell(), model_.hiddenPaths());
    request.show = pathsOfLive(model_.cell(), model_.shownPaths());
    request.camera = viewpointNow(model_);
  }
  loader_.start(std::move(request));
  return {};
}

Status Opening::goBack() {
  if (auto begun = begin(); !begun) return begun;
  if (left_.empty()) return badArgument("no live session goes on behind what is shown");
  back_ = 0;
  return {};
}

Status Opening::disconnect(bool forgets) {
  if (auto begun = begin(); !begun) return begun;
  const bool is_shown = model_.isLive();
  if (!is_shown && left_.empty()) return badArgument("this window listens nowhere");
  if (!forgets && hasHeard(is_shown ? model_ : left_.model(0))) {
    return is_shown ? wouldBeLost() : wouldBeLostBehind();
  }
  if (is_shown) {
    loader_.start(withoutConnection(shown_, forgets));
  } else {
    model_.viewer.panels.open.ended = endedText(left_.request(0), left_.model(0));
    left_.forget(0);
    tellLeft();
  }
  return {};
}

Result<std::optional<Opening::Loaded>> Opening::take(bool waits) {
  std::optional<Loaded> loaded;
  if (unread_) {
    loaded.emplace();
    loaded->fault = std::exchange(unread_, std::nullopt)->text();
    return loaded;
  }
  if (back_) {
    loaded.emplace();
    loaded->content = left_.take(*std::exchange(back_, std::nullopt));
    loaded->goes_back = true;
    return loaded;
  }
  if (auto begun = loadLater(); !begun) {
    loaded.emplace();
    loaded->fault = begun.error().text();
    return loaded;
  }
  auto result = loader_.waitFor(waits ? kLongestReading : Nanoseconds(0));
  if (!result) return loaded;
  model_.viewer.panels.open.beside_comes = false;
  loaded.emplace();
  if (std::exchange(gives_up_beside_, false)) {
    loaded->fault =
        plainText(loader_.name()) + " is not shown beside: `beside none` came before it was loaded";
    return loaded;
  }
  if (result->ok()) {
    if ((*result)->beside) {
      loaded->fault = takeBeside(std::move(**result));
      return loaded;
    }
    const ContentRequest& next = (*result)->request;
    // What is shown may have heard something only meanwhile.
    if (auto may = mayLeave(next); !may) {
      const bool shows = next.leaving != ContentRequest::Leaving::ends_unheard;
      loaded->fault =
          (shows ? plainText(next.title()) + " is not shown: " : std::string()) + may.error().what;
      return loaded;
    }
    loaded->content = std::make_unique<ViewContent>(std::move(**result));
    offerBeside(*loaded->content);
  } else if (model_.viewer.is_empty && !model_.viewer.panels.open.used) {
    return result->error();
  } else if ((model_.isLive() || !left_.empty()) && isOwnPort(result->error())) {
    loaded->fault =
        "this window listens at that port itself: `disconnect` ends that, `live` shows what it "
        "left";
  } else {
    loaded->fault = faultInWindow(result->error().text());
  }
  return loaded;
}

std::optional<LoadingStatus> Opening::status() const {
  if (!loader_.busy()) return std::nullopt;
  std::string then = gives_up_beside_ ? "it is not shown beside" : "";
  if (loader_.hasLater()) {
    if (!then.empty()) then += "; ";
    then += plainText(loader_.later().front().filename().string());
    const std::size_t more = loader_.filesLater() - 1;
    then += more > 0 ? fmt::format(" and {} more are opened then", more) : " is opened then";
  }
  return LoadingStatus{loader_.name(), loader_.progress(), std::move(then)};
}

}  // namespace rocinante
