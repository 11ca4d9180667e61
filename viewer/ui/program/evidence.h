#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/model_search.h"
#include "core/base/result.h"
#include "viewer/view/camera.h"
#include "viewer/view/render_style.h"

namespace rocinante {

/// A picture of what the window shows, to be made by rocinante-render in the reproducible profile,
/// so that anybody can make the same bytes again.
struct EvidenceRequest : ModelSearch {
  std::filesystem::path cell, log;  ///< as the viewer was given them; `log` may be empty
  std::string at;                   ///< RFC 3339, to the nanosecond; empty without a log
  std::string camera;               ///< by name; empty: `view`
  CameraView view;
  int width = 0, height = 0, samples = 4;
  double scale = 1;
  std::vector<std::string> hide, show, insets;
  RenderStyle style;
  std::filesystem::path output;
};

/// The words of `rocinante-render` for it, without the program's own name.
std::vector<std::string> evidenceArguments(const EvidenceRequest& request);

/// A picture that was made.
struct EvidenceMade {
  std::filesystem::path file;
  std::string doubt;  ///< a sentence on why it may not show what was; empty: nothing says so
};

/// A rocinante-render at work. It has its own process, so that the window goes on; what it says is
/// kept. One thread.
class EvidenceRun {
 public:
  /// The program beside this one, else that of PATH. refused when it cannot be started.
  static Result<EvidenceRun> start(const EvidenceRequest& request);
  /// Ends it when it still runs: it leaves no half file.
  ~EvidenceRun();
  EvidenceRun(EvidenceRun&& other) noexcept;
  EvidenceRun& operator=(EvidenceRun&&) = delete;

  /// Empty while it runs; then the file, or the sentence with which it refused. Does not wait.
  std::optional<Result<EvidenceMade>> poll() { return look(false); }
  Result<EvidenceMade> wait() { return *look(true); }

 private:
  EvidenceRun() = default;
  std::optional<Result<EvidenceMade>> look(bool wait);

  pid_t process_ = -1;
  int said_ = -1;  ///< what it writes on standard error
  std::filesystem::path output_;
};

/// "evidence-STEM-12.500s.png" in `folder`, or with -2, -3 behind it when that is taken.
std::filesystem::path freeEvidenceName(const std::filesystem::path& folder, const std::string& stem,
                                       const std::string& moment);

}  // namespace rocinante
