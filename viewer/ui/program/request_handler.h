#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/program/detail_choice.h"
#include "viewer/ui/program/evidence_files.h"
#include "viewer/ui/program/moment_preview.h"
#include "viewer/ui/program/opening.h"
#include "viewer/ui/program/save_files.h"
#include "viewer/ui/program/window_picture.h"
#include "viewer/ui/window/window.h"

namespace rocinante {

/// Does what the panels, keys and scripts of a frame ask of the program, and tells the user what
/// became of it. Main thread; borrows all parts.
class RequestHandler {
 public:
  struct Parts {
    const ContentRequest& shown;
    ViewModel& model;
    Window& window;
    Opening& opening;
    WindowPicture& picture;
    MomentPreview& preview;
    DetailChoice& detail;
    EvidenceFiles& evidence;
  };

  /// Under a script a frame waits for the files that are made, and a fault ends it; a user reads
  /// it, and works on.
  RequestHandler(const Parts& parts, bool scripted)
      : parts_(parts), scripted_(scripted), saving_(parts.shown) {}

  Status apply(const ViewerRequests& requests, const WindowSize& size, SteadyTime now);
  void openFiles(const std::vector<std::filesystem::path>& files, SteadyTime now) {
    tellRefusal(parts_.opening.open(files), now);
  }

  /// The coming frame is to be written to files, for a user.
  bool awaitsScreenshot() const { return !screenshots_.empty(); }
  std::vector<std::filesystem::path> takeScreenshots() { return std::exchange(screenshots_, {}); }
  bool isSaving() const { return saving_.active(); }
  /// Waits for what users asked for and is still being made, after they closed the window; a signal
  /// ends it. What fails becomes a doubt.
  void finish(SteadyTime now);

 private:
  Status look(const ViewerRequests& requests, const WindowSize& size, SteadyTime now);
  Status makeFiles(const ViewerRequests& requests, const WindowSize& size, SteadyTime now);
  Status makeEvidence(const ViewerRequests& requests, const WindowSize& size, SteadyTime now);
  Status addCamera(const std::string& name, SteadyTime now);
  Status saveLive(const std::filesystem::path& file, SteadyTime now);
  Status connect(const ViewerRequests& requests);
  void tellRefusal(const Status& begun, SteadyTime now);
  void tellNews(SteadyTime now);
  void say(std::string text, bool is_fault, SteadyTime now) {
    parts_.evidence.say(std::move(text), is_fault, now);
  }

  Parts parts_;
  bool scripted_;
  SaveFiles saving_;
  std::vector<std::filesystem::path> screenshots_;
};

}  // namespace rocinante
