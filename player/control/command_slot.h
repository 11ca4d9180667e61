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

/// One command on its way from the thread that hears it to the one that sends, and its answer back.
/// The sender never waits here: it looks at one atomic number.
class CommandSlot final : public CommandSource {
 public:
  static Result<std::unique_ptr<CommandSlot>> make();
  ~CommandSlot() override;
  CommandSlot(const CommandSlot&) = delete;
  CommandSlot& operator=(const CommandSlot&) = delete;

  /// Readable while a command waits for the sender.
  int wake() const { return wake_; }
  /// Readable when something was told, and when the slot is closed.
  int told() const { return told_; }

  // The one that hears:
  /// Hands a line over and waits for its answer. Empty: there is none.
  std::string ask(std::string line);
  std::vector<std::string> takeTold();
  bool closed() const { return state_.load(std::memory_order_acquire) == kClosed; }

  // The one that sends:
  std::optional<std::string_view> asked() override;
  void answer(std::string line) override;
  void tell(std::string line) override;
  /// Nobody will answer any more.
  void close();

 private:
  CommandSlot(int wake, int told) : wake_(wake), told_(told) {}
  void takeWakes();

  static constexpr int kIdle = 0, kAsked = 1, kAnswered = 2, kClosed = 3;

  int wake_, told_;
  std::atomic<int> state_{kIdle};
  // The sender's own:
  bool seen_ = false;
  std::int64_t wakes_owed_ = 0;  ///< of commands seen, wakes that were not taken yet

  std::string line_, answer_;
  std::mutex mutex_;
  std::vector<std::string> told_lines_;
};

}  // namespace rocinante
