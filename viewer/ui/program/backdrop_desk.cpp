#include "viewer/ui/program/backdrop_desk.h"

#include <utility>

namespace rocinante {

BackdropDesk::BackdropDesk(Backdrop* backdrop, void (*tell)()) : backdrop_(backdrop), tell_(tell) {
  if (backdrop_ != nullptr) thread_ = std::thread([this] { work(); });
}

BackdropDesk::~BackdropDesk() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  news_.notify_all();
  thread_.join();
}

void BackdropDesk::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    news_.wait(lock, [this] { return ends_ || (wanted_ && wanted_ != made_); });
    if (ends_) return;
    const std::size_t number = *wanted_;
    lock.unlock();
    auto picture = backdrop_->picture(number, [this] { return ends_.load(); });
    lock.lock();
    // A fault takes the place of its picture: it is not asked for again and again.
    made_ = number;
    picture_ = picture.ok() ? std::move(*picture) : nullptr;
    if (!picture.ok() && !ends_ && fault_.empty()) fault_ = picture.error().text();
    news_.notify_all();
    tell_();
  }
}

bool BackdropDesk::update(ViewModel& model, bool waits) {
  if (backdrop_ == nullptr || !model.backdrop) return false;
  BackdropChoice& choice = *model.backdrop;
  std::shared_ptr<const BackdropPicture> shown = choice.picture;
  const Nanoseconds time = model.shownTime() - model.origin() - choice.offset;
  // numberAt() only reads what the other thread does not change.
  const auto number = choice.shown ? backdrop_->numberAt(time) : std::nullopt;
  std::unique_lock lock(mutex_);
  if (number != wanted_) {
    wanted_ = number;
    news_.notify_all();
  }
  if (waits && number) news_.wait(lock, [&] { return made_ == number; });
  // While another one is read, the one before stays.
  if (!number) {
    shown.reset();
  } else if (made_) {
    shown = picture_;
  }
  const bool changed = choice.picture != shown;
  choice.picture = std::move(shown);
  return changed;
}

std::string BackdropDesk::takeFault() {
  const std::lock_guard lock(mutex_);
  return std::exchange(fault_, {});
}

}  // namespace rocinante
