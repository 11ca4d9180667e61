#include "player/control/command_slot.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace rocinante {
namespace {

void raise(int descriptor) {
  const std::uint64_t one = 1;
  // A full counter is already raised.
  [[maybe_unused]] const auto written = ::write(descriptor, &one, sizeof one);
}

/// Returns how often it had been raised.
std::int64_t lower(int descriptor) {
  std::int64_t count = 0;
  return ::read(descriptor, &count, sizeof count) == sizeof count ? count : 0;
}

}  // namespace

Result<std::unique_ptr<CommandSlot>> CommandSlot::make() {
  const int wake = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
  const int announced = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
  if (wake < 0 || announced < 0) {
    return Error{ErrorKind::refused,
                 std::string("cannot set up the player's control: ") + std::strerror(errno),
                 {}};
  }
  return std::unique_ptr<CommandSlot>(new CommandSlot(wake, announced));
}

CommandSlot::~CommandSlot() {
  ::close(wake_);
  ::close(announced_);
}

std::string CommandSlot::ask(std::string line) {
  if (closed()) return {};
  line_ = std::move(line);
  int idle = kIdle;
  if (!state_.compare_exchange_strong(idle, kAsked, std::memory_order_acq_rel)) return {};
  raise(wake_);
  state_.wait(kAsked, std::memory_order_acquire);
  int answered = kAnswered;
  if (state_.load(std::memory_order_acquire) != kAnswered) return {};
  std::string answer = std::move(answer_);
  state_.compare_exchange_strong(answered, kIdle, std::memory_order_acq_rel);
  // Wakes close(), which may be waiting.
  state_.notify_all();
  return answer;
}

std::optional<std::string_view> CommandSlot::asked() {
  // A command may be seen before its wake is raised, and a pending wake would prevent sleeping.
  // Take the wakes first, then the command: an early wake belongs to a command seen below.
  takeWakes();
  if (state_.load(std::memory_order_acquire) != kAsked) return std::nullopt;
  if (!std::exchange(seen_, true)) {
    ++wakes_owed_;
    takeWakes();
  }
  return line_;
}

void CommandSlot::takeWakes() {
  if (wakes_owed_ > 0) wakes_owed_ -= lower(wake_);
}

void CommandSlot::answer(std::string line) {
  answer_ = std::move(line);
  seen_ = false;
  state_.store(kAnswered, std::memory_order_release);
  state_.notify_all();
}

void CommandSlot::tell(std::string line) {
  {
    const std::lock_guard lock(mutex_);
    announced_lines_.push_back(std::move(line));
  }
  raise(announced_);
}

std::vector<std::string> CommandSlot::takeAnnounced() {
  lower(announced_);
  const std::lock_guard lock(mutex_);
  return std::exchange(announced_lines_, {});
}

void CommandSlot::close() {
  // An answer just given must still be delivered.
  int state = state_.load(std::memory_order_acquire);
  while (state == kAnswered) {
    state_.wait(kAnswered, std::memory_order_acquire);
    state = state_.load(std::memory_order_acquire);
  }
  state_.store(kClosed, std::memory_order_release);
  state_.notify_all();
  raise(announced_);
}

}  // namespace rocinante
