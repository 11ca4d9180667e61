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

/// Closes pieces and deletes them in a thread of its own, one thing after another in the order
/// asked for: closing waits for the disk, and what is recorded must not wait with it. The thread
/// begins with the first thing to do.
class PieceCloser {
 public:
  struct Done {
    std::unique_ptr<PieceLog> piece;  ///< that was closed; null: the file of `facts` was deleted
    PieceFacts facts;                 ///< as they are in the end
    Status status;
    bool was_gone = false;  ///< another file stands there by now, or none: nothing was deleted
  };

  PieceCloser() = default;
  ~PieceCloser();
  PieceCloser(const PieceCloser&) = delete;
  PieceCloser& operator=(const PieceCloser&) = delete;

  /// `facts` beside what the piece itself knows: its triggers. Waits while kMaxWaiting others
  /// wait, so that a disk that is too slow is met by the recorder's queue, which counts.
  void close(std::unique_ptr<PieceLog> piece, std::string reason, PieceFacts facts);
  /// Deletes the file, if it is still the one that was made.
  void remove(PieceFacts facts);

  /// What was done since the last call.
  std::vector<Done> takeDone();
  /// The same once everything asked for is done.
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
