#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/program/left_sessions.h"
#include "viewer/ui/program/view_content.h"

namespace rocinante {

/// Opens files, and connects to endpoints, in a window that shows something already. What is live
/// goes on behind what is shown then (LeftSessions). Main thread; borrows all.
class Opening {
 public:
  Opening(ContentLoader& loader, LeftSessions& left, ViewContent& shown);

  /// Something is loaded, or is to be loaded then.
  bool busy() const { return loader_.busy() || loader_.hasLater(); }
  /// Starts to load what was opened or dropped, or keeps it until what is loaded has come; refused
  /// with a sentence for the user.
  Status open(const std::vector<std::filesystem::path>& files);
  /// Starts to load a log to be shown beside the one that is shown, or ends the one that is. What
  /// is shown stays as it is until it has come, and if it is bad. One that is still being loaded
  /// ends, too: it is not shown when it has come. refused, bad_argument or not_found with a
  /// sentence.
  Status showBeside(const BesideWish& wish);
  /// Listens at endpoints, as they were typed, with the cell that is shown; at those of a session
  /// that was left, goes back to it. refused or bad_argument with a sentence; what is wrong with
  /// their text comes by take(), but nothing is loaded for it.
  Status connect(const std::vector<std::string>& endpoints);
  /// Shows the live session that was left last. bad_argument when there is none.
  Status goBack();
  /// Ends the live session that is shown, of which the cell at rest stays, or else the one that was
  /// left last. `forgets`: also one that has heard something; otherwise that is refused, here or in
  /// take() if it hears it meanwhile.
  Status disconnect(bool forgets);

  /// What came of it, once it has come.
  struct Loaded {
    std::unique_ptr<ViewContent> content;  ///< null: it cannot be read, or is shown beside now
    std::string fault;                     ///< why it cannot, for the user; empty: it can
    bool goes_back = false;                ///< it was shown before, and is not refused
  };
  /// Fails with what cannot be read when that is all that was asked for. `waits`: until it has
  /// come.
  Result<std::optional<Loaded>> take(bool waits);

  /// To be called now and then.
  void tend(SteadyTime now) { left_.tend(now); }
  std::optional<LoadingStatus> status() const;

 private:
  Status begin();
  Status load(const std::vector<std::filesystem::path>& files);
  /// Starts with what was opened meanwhile, once nothing else is loaded.
  Status loadLater();
  Status mayBegin() const;
  /// Shows a log that was read beside what is shown; why not, or empty.
  std::string takeBeside(ViewContent read);
  /// The log that is shown beside the one that takes its place.
  void offerBeside(ViewContent& next) const;
  /// Whether the live session that is shown may give way to what is asked for, or has come by now:
  /// nothing that it heard is lost, and there is room for it behind that.
  Status mayLeave(const ContentRequest& next) const;
  void tellLeft() { model_.viewer.panels.open.left = left_.names(); }

  ContentLoader& loader_;
  LeftSessions& left_;
  ViewContent& content_;
  ViewModel& model_;
  ContentRequest& shown_;
  std::optional<std::size_t> back_;  ///< the session that was left and is to be shown
  std::optional<Error> unread_;      ///< what is wrong with endpoints that were typed
  bool gives_up_beside_ = false;     ///< the log that is loaded is not to be shown beside
};

}  // namespace rocinante
