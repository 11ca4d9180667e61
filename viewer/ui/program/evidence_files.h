#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "viewer/ui/program/evidence.h"
#include "viewer/ui/program/view_content.h"

namespace rocinante {

/// Size of the picture in pixels, and scale of its text.
struct WindowSize {
  int width = 0, height = 0;
  double scale = 1;
};

/// Makes evidence pictures of the window's content, one at a time, and reports the results. Main
/// thread; borrows the request.
class EvidenceFiles {
 public:
  EvidenceFiles(const ContentRequest& shown, int samples) : shown_(shown), samples_(samples) {}

  /// Starts a picture into `file`, or without one into a new file of the working folder; refuses a
  /// second one while the first is running.
  void ask(ViewModel& model, const WindowSize& size, SteadyTime now,
           const std::filesystem::path& file = {});
  /// The same into `file`, and waits for it.
  Status make(ViewModel& model, const WindowSize& size, const std::filesystem::path& file);
  /// Starts a video of the part between A and B, into `file` or a new one; bad_argument without a
  /// part. With `waits`, until it is there.
  Status makeVideo(ViewModel& model, const WindowSize& size, const std::filesystem::path& file,
                   SteadyTime now, bool waits);
  /// Appends the picture to a suite as a case.
  Status addCase(ViewModel& model, const WindowSize& size, const std::string& name,
                 const std::filesystem::path& suite, SteadyTime now, bool waits);
  /// Checks whether the running picture is finished.
  void look(SteadyTime now);

  /// Shows a sentence for a while.
  void say(std::string text, bool fault, SteadyTime now);
  const std::string& notice() const { return notice_; }
  bool noticeIsFault() const { return notice_is_fault_; }
  /// A child program is at work.
  bool isMaking() const { return running_.has_value(); }
  /// look() may soon change the notice.
  bool active() const { return running_.has_value() || !notice_.empty(); }

 private:
  Status begin(Result<EvidenceRun> run, const std::string& what, ViewModel& model, SteadyTime now,
               bool waits);
  Result<EvidenceRequest> requestOf(ViewModel& model, const WindowSize& size) const;

  const ContentRequest& shown_;
  int samples_;
  std::optional<EvidenceRun> running_;
  std::string what_ = "evidence";  ///< that runs
  std::string notice_;
  bool notice_is_fault_ = false;
  std::optional<SteadyTime> notice_until_;
};

}  // namespace rocinante
