#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "viewer/ui/program/view_content.h"

namespace rocinante {

/// A live session heard something, which is lost when it ends.
bool hasHeard(const ViewModel& model);

/// What ending a live session of that request does, in one line: how much it kept, which is
/// deleted.
std::string endedText(const ContentRequest& request, const ViewModel& model);

/// The live sessions of a window that shows something else: they listen and keep on. Main thread.
class LeftSessions {
 public:
  /// Beside the one that is shown. Each has a socket, threads and a kept log.
  static constexpr std::size_t kMost = 3;

  bool empty() const { return contents_.empty(); }
  std::size_t size() const { return contents_.size(); }
  /// Content gives way to the next one and sends nothing any more: others get its farewell. The
  /// next one says what becomes of it if it is live, this once: it stays here, but ends if it has
  /// heard nothing; it goes along; or it ends. One that stays is added even beyond kMost. What was
  /// asked to end is named in the next one's panels.open.ended.
  void leave(std::unique_ptr<ViewContent> content, ViewContent& next);
  /// Their endpoints, as endpointsText(), the one that was shown last first.
  std::vector<std::string> names() const;
  /// The number of the one with these endpoints, as they were typed or as names() has them.
  std::optional<std::size_t> find(const std::vector<std::string>& endpoints) const;
  const ContentRequest& request(std::size_t number) const { return contents_[number]->request; }
  const ViewModel& model(std::size_t number) const { return *contents_[number]->model; }
  /// Gives one back to be shown.
  std::unique_ptr<ViewContent> take(std::size_t number);
  /// Ends one: what it kept is deleted.
  void forget(std::size_t number) { take(number).reset(); }
  /// To be called now and then: each takes what it heard, and lets go of what is no longer kept.
  void tend(SteadyTime now);

 private:
  std::vector<std::unique_ptr<ViewContent>> contents_;  ///< the one shown last first
  std::optional<SteadyTime> tended_;
};

}  // namespace rocinante
