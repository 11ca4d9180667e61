#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "core/recording/piece_log.h"

namespace rocinante {

/// Closes and deletes pieces in its own thread, in the order requested: closing waits for the disk,
/// and recording must not. The thread starts with the first request.
class PieceCloser {
 public:
  struct Done {
    std::unique_ptr<PieceLog> piece;  ///< the closed piece; null: the file of `facts` was deleted
    PieceFacts facts;                 ///< final
    Status status;
    bool was_gone = false;  ///< the file was missing or replaced by another, so nothing was deleted
  };

  PieceCloser() = default;
  ~PieceCloser();
  PieceCloser(const PieceCloser&) = delete;
  PieceCloser& operator=(const PieceCloser&) = delete;

  /// `facts` holds what the piece does not know: its triggers. Blocks while kMaxWaiting others
  /// wait, so that a slow disk fills the recorder's queue, which counts losses.
  void close(std::unique_ptr<PieceLog> piece, std::string reason, PieceFacts facts);
  /// Deletes the file if it is still the recorder's own.
  void remove(PieceFacts facts);

  /// What was done since the last call.
  std::vector<Done> takeDone();
  /// The same after everything requested is done.
  std::vector<Done> finish();

  static constexpr std::size_t kMaxWaiting = 8;

 private:
  struct Closing {
    std::unique_ptr<PieceLog> piece;
    std::string reason;
    PieceFacts facts;
  };
  using Job = std::variant<Closing, PieceFacts>;

  void add(Job job);
  void work();
  static Done done(Job job);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  bool busy_ = false;
  bool stop_ = false;
  std::vector<Done> done_;
  std::thread thread_;
};

}  // namespace rocinante
