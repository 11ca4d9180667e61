#include "recorder/pieces/piece_closer.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "recorder/pieces/thread_without_signals.h"

namespace rocinante {

PieceCloser::~PieceCloser() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void PieceCloser::close(std::unique_ptr<PieceLog> piece, std::string reason, PieceFacts facts) {
  add(Closing{std::move(piece), std::move(reason), std::move(facts)});
}

void PieceCloser::remove(PieceFacts facts) { add(std::move(facts)); }

void PieceCloser::add(Job job) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return jobs_.size() < kMaxWaiting; });
  jobs_.push_back(std::move(job));
  if (!thread_.joinable()) thread_ = threadWithoutSignals("close", [this] { work(); });
  changed_.notify_all();
}

/// Returns when asked to end and nothing is left to do.
void PieceCloser::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return stop_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    busy_ = true;
    lock.unlock();
    Done what = done(std::move(job));
    lock.lock();
    done_.push_back(std::move(what));
    busy_ = false;
    changed_.notify_all();
  }
}

PieceCloser::Done PieceCloser::done(Job job) {
  Done done;
  if (auto* const closing = std::get_if<Closing>(&job)) {
    done.status = closing->piece->close(closing->reason);
    PieceFacts facts = closing->piece->facts();
    facts.triggers = closing->facts.triggers;
    facts.why = std::move(closing->facts.why);
    facts.triggered = closing->facts.triggered;
    facts.cut_short = closing->facts.cut_short;
    done.facts = std::move(facts);
    done.piece = std::move(closing->piece);
    return done;
  }
  done.facts = std::move(std::get<PieceFacts>(job));
  const std::filesystem::path& path = done.facts.file.path;
  done.was_gone = !done.facts.file.isThere();
  if (done.was_gone) return done;
  std::error_code ignored;
  done.facts.bytes = std::filesystem::file_size(path, ignored);
  if (::unlink(path.c_str()) != 0) {
    done.status =
        Error{ErrorKind::unreadable, std::string("cannot delete a piece: ") + std::strerror(errno),
              path.string()};
  }
  return done;
}

std::vector<PieceCloser::Done> PieceCloser::takeDone() {
  const std::lock_guard lock(mutex_);
  return std::exchange(done_, {});
}

std::vector<PieceCloser::Done> PieceCloser::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return jobs_.empty() && !busy_; });
  return std::exchange(done_, {});
}

}  // namespace rocinante
