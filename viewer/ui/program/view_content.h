#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/base/result.h"
#include "viewer/backdrop/backdrop.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/program/beside_log.h"
#include "viewer/ui/program/content_request.h"
#include "viewer/ui/study/worker.h"

namespace rocinante {

/// What is shown: a model and where it came from.
struct ViewContent {
  ContentRequest request;  ///< `cell` and `log` as they were found
  std::unique_ptr<ViewModel> model;
  std::unique_ptr<Backdrop> backdrop;  ///< null: none
  /// One sentence each, to be printed. The model's panels have those that stay over the picture.
  std::vector<std::string> warnings;
  std::shared_ptr<const PrivateFolder> beside_folder;  ///< a temporary log beside lies in it
  std::optional<BesideLog> beside{};  ///< read alone (ContentRequest): then there is no model
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

  /// Files that are to be opened together, after what is loaded; in turn, if there are more.
  void keepForLater(std::vector<std::filesystem::path> files) {
    later_.push_back(std::move(files));
  }
  bool hasLater() const { return !later_.empty(); }
  /// Those that are next; only if hasLater().
  const std::vector<std::filesystem::path>& later() const { return later_.front(); }
  /// The number of all that are waiting.
  std::size_t filesLater() const {
    std::size_t count = 0;
    for (const auto& together : later_) count += together.size();
    return count;
  }
  std::vector<std::filesystem::path> takeLater() {
    std::vector<std::filesystem::path> files = std::move(later_.front());
    later_.pop_front();
    return files;
  }

  const std::string& name() const { return name_; }
  LoadProgress progress() const;

 private:
  std::string name_;
  bool busy_ = false;
  std::deque<std::vector<std::filesystem::path>> later_;
  mutable std::mutex mutex_;
  LoadProgress progress_;  ///< guarded by mutex_
  /// Made on first use. One for all: its end would stop the sessions that it has opened.
  std::optional<Worker<ContentRequest, Result<ViewContent>>> worker_;
};

}  // namespace rocinante
