#include "viewer/program/background_writer.h"

#include <exception>
#include <utility>

namespace rocinante {
namespace {

constexpr std::size_t kMaxWaiting = 8;
/// May exceed the cores, because writing to disk is mostly waiting.
constexpr std::size_t kWriterThreads = 4;

/// An exception of a library must not leave the thread.
Status outcomeOf(const std::function<Status()>& task) {
  try {
    return task();
  } catch (const std::exception& fault) {
    return Error{ErrorKind::refused, std::string("cannot write a picture: ") + fault.what(), {}};
  }
}

}  // namespace

BackgroundWriter::BackgroundWriter() {
  for (std::size_t i = 0; i < kWriterThreads; ++i) threads_.emplace_back([this] { work(); });
}

BackgroundWriter::~BackgroundWriter() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

Status BackgroundWriter::add(std::function<Status()> task) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return failure_ || waiting_.size() < kMaxWaiting; });
  if (failure_) return *failure_;
  waiting_.push_back(std::move(task));
  changed_.notify_all();
  return {};
}

Status BackgroundWriter::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return waiting_.empty() && busy_ == 0; });
  if (failure_) return *failure_;
  return {};
}

void BackgroundWriter::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return ending_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const std::function<Status()> task = std::move(waiting_.front());
    waiting_.pop_front();
    ++busy_;
    changed_.notify_all();
    if (!failure_) {
      lock.unlock();
      const Status status = outcomeOf(task);
      lock.lock();
      if (!status && !failure_) failure_ = status.error();
    }
    --busy_;
    changed_.notify_all();
  }
}

}  // namespace rocinante
