#include "recorder/capture/writing.h"

#include "recorder/capture/prompt_thread.h"
#include "recorder/pieces/thread_without_signals.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kWriteWait = std::chrono::milliseconds(10);
/// Well within the tenth of a second that a kill may repeat (docs/endpoints.md).
constexpr Nanoseconds kSavePeriod = std::chrono::milliseconds(50);

}  // namespace

Writing::Writing(CaptureWriter& writer, HandOver& queue, InputLoop& input)
    : writer_(writer), queue_(queue), input_(input), thread_(threadWithoutSignals("write", [this] {
        askToRunPromptly();
        write();
      })) {}

void Writing::save(SteadyTime now) {
  if (!input_.keepsPlace() || now - saved_at_ < kSavePeriod) return;
  saved_at_ = now;
  if (const auto count = writer_.save()) input_.noteSaved(*count);
}

void Writing::write() {
  Requests done;
  for (bool finished = false; !finished;) {
    TakenOver taken = queue_.take(kWriteWait);
    finished = taken.finished;
    writer_.write(std::move(taken), queue_);
    Requests asked;
    {
      const std::lock_guard lock(mutex_);
      asked = requests_;
    }
    if (asked.seams != done.seams) writer_.askForSeam();
    if (asked.triggers != done.triggers) writer_.trigger("signal");
    done = asked;
    const SteadyTime now = std::chrono::steady_clock::now();
    writer_.flush(now);
    save(now);
    const Progress reached{writer_.started(), writer_.over(),     writer_.packets(),
                           writer_.lost(),    writer_.logBytes(), writer_.held()};
    const std::lock_guard lock(mutex_);
    progress_ = reached;
  }
}

void Writing::ask(const Requests& requests) {
  const std::lock_guard lock(mutex_);
  requests_ = requests;
}

Writing::Progress Writing::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

void Writing::join() {
  if (thread_.joinable()) thread_.join();
}

}  // namespace rocinante
