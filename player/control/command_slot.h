#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "player/playhead/playhead_sender.h"

namespace rocinante {

/// Passes one command from the listening thread to the sending thread, and its answer back. The
/// sender never blocks: it reads one atomic number.
class CommandSlot final : public CommandSource {
 public:
  static Result<std::unique_ptr<CommandSlot>> make();
  ~CommandSlot() override;
  CommandSlot(const CommandSlot&) = delete;
  CommandSlot& operator=(const CommandSlot&) = delete;

  /// Readable while a command waits for the sender.
  int wake() const { return wake_; }
  /// Readable after tell(), and when the slot is closed.
  int announced() const { return announced_; }

  // The listening thread:
  /// Hands over a line and waits for its answer; empty for none.
  std::string ask(std::string line);
  std::vector<std::string> takeAnnounced();
  bool closed() const { return state_.load(std::memory_order_acquire) == kClosed; }

  // The sending thread:
  std::optional<std::string_view> asked() override;
  void answer(std::string line) override;
  void tell(std::string line) override;
  /// No more answers will come.
  void close();

 private:
  CommandSlot(int wake, int announced) : wake_(wake), announced_(announced) {}
  void takeWakes();

  static constexpr int kIdle = 0, kAsked = 1, kAnswered = 2, kClosed = 3;

  int wake_, announced_;
  std::atomic<int> state_{kIdle};
  // Used by the sending thread only:
  bool seen_ = false;
  std::int64_t wakes_owed_ = 0;  ///< wakes of seen commands that were not taken yet

  std::string line_, answer_;
  std::mutex mutex_;
  std::vector<std::string> announced_lines_;
};

}  // namespace rocinante
