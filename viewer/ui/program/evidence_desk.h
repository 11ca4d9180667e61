#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "viewer/ui/program/evidence.h"
#include "viewer/ui/program/view_app.h"

namespace rocinante {

/// Of the picture, in pixels, and how large its text is.
struct WindowSize {
  int width = 0, height = 0;
  double scale = 1;
};

/// Takes orders for evidence pictures of what the window shows, one at a time, and says what became
/// of them. Main thread; borrows the options.
class EvidenceDesk {
 public:
  explicit EvidenceDesk(const ViewOptions& options) : options_(options) {}

  /// Begins a picture in the working folder; a second one while the first is at work is refused.
  void ask(ViewModel& model, const WindowSize& size, SteadyTime now);
  /// The same into `file`, and waits for it.
  Status make(ViewModel& model, const WindowSize& size, const std::filesystem::path& file);
  /// Looks whether the picture at work is done.
  void look(SteadyTime now);

  /// A sentence to be shown for a while.
  void say(std::string text, bool fault, SteadyTime now);
  const std::string& notice() const { return notice_; }
  bool noticeIsFault() const { return notice_is_fault_; }

 private:
  Result<EvidenceRequest> requestOf(ViewModel& model, const WindowSize& size) const;

  const ViewOptions& options_;
  std::optional<EvidenceRun> running_;
  std::string notice_;
  bool notice_is_fault_ = false;
  std::optional<SteadyTime> notice_until_;
};

}  // namespace rocinante
