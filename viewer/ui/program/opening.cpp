#include "viewer/ui/program/opening.h"

#include <chrono>
#include <utility>

namespace rocinante {
namespace {

constexpr Nanoseconds kLongestReading = std::chrono::hours(24);

}  // namespace

Status Opening::open(const std::vector<std::filesystem::path>& files) {
  if (files.empty()) return {};
  if (loader_.busy()) {
    return Error{ErrorKind::refused, "wait until " + loader_.name() + " is loaded", {}};
  }
  model_.viewer.panels.open.used = true;
  model_.viewer.panels.notes.clear();
  auto request = requestOf(files, shown_);
  if (!request.ok()) return request.error();
  loader_.start(std::move(*request));
  return {};
}

Result<std::optional<Opening::Loaded>> Opening::take(bool waits) {
  std::optional<Loaded> loaded;
  auto result = loader_.waitFor(waits ? kLongestReading : Nanoseconds(0));
  if (!result) return loaded;
  loaded.emplace();
  if (result->ok()) {
    loaded->content = std::make_unique<ViewContent>(std::move(**result));
  } else if (model_.viewer.is_empty && !model_.viewer.panels.open.used) {
    return result->error();
  } else {
    loaded->fault = result->error().text();
  }
  return loaded;
}

std::optional<LoadingStatus> Opening::status() const {
  if (!loader_.busy()) return std::nullopt;
  return LoadingStatus{loader_.name(), loader_.progress(), {}};
}

}  // namespace rocinante
