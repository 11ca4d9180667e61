#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/model_search.h"
#include "core/base/parallel_for.h"
#include "core/base/result.h"
#include "core/bundle/private_folder.h"
#include "viewer/backdrop/backdrop.h"
#include "viewer/ui/live/keep_limits.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/study/worker.h"

namespace rocinante {

/// What the window shall show, as arguments of the program say it or as opened in the window.
struct ContentRequest {
  std::filesystem::path cell;    ///< empty: nothing, or the cell that the log carries
  std::filesystem::path log;     ///< empty: none
  std::filesystem::path beside;  ///< another log of the cell, shown as ghosts; empty: none
  std::string align;             ///< of it, for alignBeside()
  /// Shown with a log that carries no cell; empty: there is none.
  std::filesystem::path fallback_cell;
  std::optional<std::vector<Endpoint>> live;
  std::string trust;
  std::string decoders;             ///< of a live session: a file; empty: those of the cell
  KeepLimits keep;                  ///< of a live session
  std::vector<std::string> joints;  ///< moved by hand: a device's values, as --joints
  std::string drive, drive_as;      ///< an endpoint and a SOURCE for joints by hand; empty: neither
  std::string publish, publish_as;  ///< an endpoint and a SOURCE for other windows; empty: neither
  std::vector<std::string> hide, show, styles;
  std::string camera, at;
  bool at_event = false;  ///< `at` is the name of an event, never a time
  BackdropRequest backdrop;
  ModelSearch where;

  bool empty() const { return cell.empty() && log.empty(); }
  /// The file that gives it its name.
  const std::filesystem::path& named() const { return log.empty() ? cell : log; }
};

/// What is shown: a model and where it came from.
struct ViewContent {
  ContentRequest request;  ///< `cell` and `log` as they were found
  std::unique_ptr<ViewModel> model;
  std::unique_ptr<Backdrop> backdrop;  ///< null: none
  /// One sentence each, to be printed. The model's panels have those that stay over the picture.
  std::vector<std::string> warnings;
  std::shared_ptr<const PrivateFolder> beside_folder;  ///< a temporary log beside lies in it
};

/// Errors of the cell and its files, and what of them is left out.
std::vector<PictureNote> notesOf(const Cell& cell);

/// The cell has nothing to draw, and errors that say why.
bool isHopeless(const Cell& cell);

/// Reads files and starts a live feed; any thread. `progress` may be called by other threads. Once
/// `stop` is asked for, reading or importing a log ends soon, with an error.
Result<ViewContent> loadContent(ContentRequest request, const TellLoadProgress& progress,
                                const std::stop_token& stop = {});

/// Nothing: an empty cell.
ViewContent emptyContent();

/// What files that were dropped on a window or opened in it mean, while `shown` is there: a cell or
/// model, a log, or one of each. bad_argument with a sentence otherwise.
Result<ContentRequest> requestOf(const std::vector<std::filesystem::path>& files,
                                 const ContentRequest& shown);

/// Loads in a thread of its own. All calls from one thread. Outlives what it loaded, whose session
/// reads no more once this has ended.
class ContentLoader {
 public:
  /// Something was started and not taken.
  bool busy() const { return busy_; }
  /// Not while busy(). Of what is being read when this ends only a cell is read to its end.
  void start(ContentRequest request);
  /// What was loaded, once; empty while it is not ready or nothing was started.
  std::optional<Result<ViewContent>> poll() { return waitFor(Nanoseconds(0)); }
  /// The same, after at most `most`.
  std::optional<Result<ViewContent>> waitFor(Nanoseconds most);

  const std::string& name() const { return name_; }
  LoadProgress progress() const;

 private:
  std::string name_;
  bool busy_ = false;
  mutable std::mutex mutex_;
  LoadProgress progress_;  ///< guarded by mutex_
  /// Made on first use. One for all: its end would stop the sessions that it has opened.
  std::optional<Worker<ContentRequest, Result<ViewContent>>> worker_;
};

}  // namespace rocinante
