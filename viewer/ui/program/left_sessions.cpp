#include "viewer/ui/program/left_sessions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kTendEvery = std::chrono::seconds(1);

}  // namespace

bool hasHeard(const ViewModel& model) {
  if (!model.isLive()) return false;
  const LiveKeeper* const keeper = model.feed().keeper();
  return (model.live() != nullptr && model.live()->datagrams > 0) ||
         (keeper != nullptr && keeper->progress().datagrams > 0);
}

std::string endedText(const ContentRequest& request, const ViewModel& model) {
  const std::string text = "disconnected from " + plainText(endpointsText(request));
  if (!hasHeard(model)) return text + ", where nothing was heard";
  const LiveKeeper* const keeper = model.feed().keeper();
  if (keeper == nullptr) return text + "; nothing of it was kept";
  const KeptProgress kept = keeper->progress();
  return fmt::format("{}; what it kept is deleted: {}, {}", text,
                     countText(kept.datagrams, "datagram"), sizeText(kept.bytes));
}

void LeftSessions::leave(std::unique_ptr<ViewContent> content, ViewContent& next) {
  using Leaving = ContentRequest::Leaving;
  // Of this change alone: when the next one comes back, it brings nothing along.
  const Leaving leaving = std::exchange(next.request.leaving, Leaving::stays_behind);
  ViewModel& model = *content->model;
  model.hand.stopDriving();
  model.publishing.end(std::chrono::steady_clock::now(), std::chrono::system_clock::now());
  if (!model.isLive()) return;
  std::string& ended = next.model->viewer.panels.open.ended;
  const bool is_heard = hasHeard(model);
  if (leaving == Leaving::ends || (leaving == Leaving::ends_unheard && !is_heard)) {
    ended = endedText(content->request, model);
    return;
  }
  if (leaving == Leaving::goes_along) {
    next.model->takeLive(model);
    next.request.live = content->request.live;
    next.request.connect = content->request.connect;
    return;
  }
  if (!is_heard) return;
  if (leaving == Leaving::ends_unheard) {
    ended = plainText(endpointsText(content->request)) +
            " was heard just now and goes on behind this: `live` shows it";
  }
  model.viewer.hover = {};  // its texture is the window's
  model.viewer.was_shown = true;
  model.viewer.panels.open.shown = model.viewer.panels.palette.shown = false;
  contents_.insert(contents_.begin(), std::move(content));
}

std::vector<std::string> LeftSessions::names() const {
  std::vector<std::string> names;
  for (const auto& content : contents_) names.push_back(endpointsText(content->request));
  return names;
}

std::optional<std::size_t> LeftSessions::find(const std::vector<std::string>& endpoints) const {
  const std::string text = fmt::format("{}", fmt::join(endpoints, " "));
  const auto found = std::ranges::find_if(contents_, [&](const auto& content) {
    return content->request.connect == endpoints || endpointsText(content->request) == text;
  });
  if (found == contents_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - contents_.begin());
}

std::unique_ptr<ViewContent> LeftSessions::take(std::size_t number) {
  const auto at = contents_.begin() + static_cast<std::ptrdiff_t>(number);
  std::unique_ptr<ViewContent> content = std::move(*at);
  contents_.erase(at);
  return content;
}

void LeftSessions::tend(SteadyTime now) {
  if (contents_.empty() || (tended_ && now - *tended_ < kTendEvery)) return;
  tended_ = now;
  for (const auto& content : contents_) {
    // What fails now is said when it is shown.
    static_cast<void>(content->model->update(now));
  }
}

}  // namespace rocinante
