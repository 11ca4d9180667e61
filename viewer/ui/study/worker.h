#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/base/thread_priority.h"
#include "core/base/time.h"

namespace rocinante {

enum class ThreadPriority { low, normal };

/// A thread that answers questions, one after the other; of those asked meanwhile only the last
/// counts. All calls from one thread, but found() and publish(). When it is destroyed the answer
/// that is being worked on is asked to stop, and waited for: it is the last member of its owner.
template <class Question, class Answer>
class Worker {
 public:
  /// `work(Question&, const std::stop_token&)` gives the Answer, in the thread, and owns what it
  /// keeps between two. `on_answer`, if any, is called by the thread after each answer.
  template <class Work>
  explicit Worker(Work work, std::function<void()> on_answer = {},
                  ThreadPriority priority = ThreadPriority::low)
      : on_answer_(std::move(on_answer)),
        thread_([this, priority, work = std::move(work)](const std::stop_token& stop) mutable {
          if (priority == ThreadPriority::low) lowerPriority();
          run(work, stop);
        }) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void ask(Question question) {
    {
      const std::lock_guard lock(mutex_);
      next_ = std::move(question);
      busy_ = true;
    }
    changed_.notify_all();
  }
  /// Something was asked and is not answered.
  bool isBusy() const {
    const std::lock_guard lock(mutex_);
    return busy_;
  }
  /// Until it is not busy.
  void wait() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !busy_; });
  }
  /// The same, at most so long; whether it is not busy.
  bool waitFor(Nanoseconds most) const {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, most, [this] { return !busy_; });
  }

  /// The last answer, also while it is busy with another one; null before the first.
  std::shared_ptr<Answer> found() const {
    const std::lock_guard lock(mutex_);
    return found_;
  }
  /// True once after each answer.
  bool takeNews() {
    const std::lock_guard lock(mutex_);
    return std::exchange(news_, false);
  }
  /// By the work: what is known of its answer so far.
  void publish(Answer answer) {
    auto found = std::make_shared<Answer>(std::move(answer));
    const std::lock_guard lock(mutex_);
    found_ = std::move(found);
    news_ = true;
  }

 private:
  template <class Work>
  void run(Work& work, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return next_.has_value(); }) &&
           !stop.stop_requested()) {
      Question question = *std::exchange(next_, std::nullopt);
      lock.unlock();
      auto found = std::make_shared<Answer>(work(question, stop));
      lock.lock();
      found_ = std::move(found);
      news_ = true;
      busy_ = next_.has_value();
      changed_.notify_all();
      lock.unlock();
      if (on_answer_) on_answer_();
      lock.lock();
    }
  }

  std::function<void()> on_answer_;
  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  // Guarded by mutex_.
  std::optional<Question> next_;
  bool busy_ = false;
  std::shared_ptr<Answer> found_;
  bool news_ = false;

  std::jthread thread_;  // last: it ends first
};

}  // namespace rocinante
