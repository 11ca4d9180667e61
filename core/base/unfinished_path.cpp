#include "core/base/unfinished_path.h"

#include <unistd.h>

#include <atomic>
#include <utility>

namespace rocinante {

/// An entry of a list that only grows, so that a signal handler can walk it without a lock.
struct UnfinishedPath::Entry {
  std::string path;
  std::atomic<bool> unfinished{true};
  Entry* older = nullptr;
};

namespace {

/// An UnfinishedPath::Entry; the type is private to UnfinishedPath.
std::atomic<void*> newest_unfinished{nullptr};
static_assert(std::atomic<void*>::is_always_lock_free, "read by a signal handler");
static_assert(std::atomic<bool>::is_always_lock_free, "read by a signal handler");

void removeFileOrFolder(const char* path) {
  if (::unlink(path) != 0) ::rmdir(path);
}

}  // namespace

UnfinishedPath::Entry* UnfinishedPath::entryFor(std::string path) {
  auto* const entry = new Entry;
  entry->path = std::move(path);
  void* older = newest_unfinished.load();
  do {
    entry->older = static_cast<Entry*>(older);
  } while (!newest_unfinished.compare_exchange_weak(older, entry));
  return entry;
}

UnfinishedPath::UnfinishedPath(std::filesystem::path path) : entry_(entryFor(path.string())) {}

UnfinishedPath::~UnfinishedPath() {
  if (entry_ != nullptr && entry_->unfinished.exchange(false)) {
    removeFileOrFolder(entry_->path.c_str());
  }
}

UnfinishedPath::UnfinishedPath(UnfinishedPath&& other) noexcept
    : entry_(std::exchange(other.entry_, nullptr)) {}

UnfinishedPath& UnfinishedPath::operator=(UnfinishedPath&& other) noexcept {
  std::swap(entry_, other.entry_);
  return *this;
}

void UnfinishedPath::keep() {
  if (entry_ != nullptr) entry_->unfinished.store(false);
}

void removeUnfinishedPaths() {
  auto* entry = static_cast<UnfinishedPath::Entry*>(newest_unfinished.load());
  for (; entry != nullptr; entry = entry->older) {
    if (entry->unfinished.exchange(false)) removeFileOrFolder(entry->path.c_str());
  }
}

EndingHeld::EndingHeld() {
  sigset_t held;
  ::sigemptyset(&held);
  for (const int number : {SIGINT, SIGTERM, SIGALRM}) ::sigaddset(&held, number);
  ::pthread_sigmask(SIG_BLOCK, &held, &former_);
}

EndingHeld::~EndingHeld() { ::pthread_sigmask(SIG_SETMASK, &former_, nullptr); }

}  // namespace rocinante
