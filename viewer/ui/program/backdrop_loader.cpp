#include "viewer/ui/program/backdrop_loader.h"

#include <utility>

namespace rocinante {

BackdropLoader::BackdropLoader(Backdrop* backdrop, void (*tell)()) : backdrop_(backdrop) {
  if (backdrop_ == nullptr) return;
  worker_.emplace(
      [backdrop, read = Read()](std::size_t number, const std::stop_token& stop) mutable {
        auto picture = backdrop->picture(number, [&] { return stop.stop_requested(); });
        // A fault takes the place of its picture: it is not asked for again and again.
        read.picture = picture.ok() ? std::move(*picture) : nullptr;
        if (!picture.ok()) {
          read.fault = picture.error().text();
          ++read.faults;
        }
        return read;
      },
      tell, ThreadPriority::normal);
}

bool BackdropLoader::update(ViewModel& model, bool waits) {
  if (backdrop_ == nullptr || !model.backdrop) return false;
  BackdropChoice& choice = *model.backdrop;
  std::shared_ptr<const BackdropPicture> shown = choice.picture;
  const Nanoseconds time = model.shownTime() - model.origin() - choice.offset;
  // numberAt() only reads what the other thread does not change.
  const auto number = choice.shown ? backdrop_->numberAt(time) : std::nullopt;
  if (number && number != asked_) {
    asked_ = number;
    worker_->ask(*number);
  }
  if (waits && number) worker_->wait();
  // While another one is read, the one before stays.
  if (!number) {
    shown.reset();
  } else if (const auto read = worker_->found()) {
    shown = read->picture;
  }
  const bool changed = choice.picture != shown;
  choice.picture = std::move(shown);
  return changed;
}

std::string BackdropLoader::takeFault() {
  const auto read = worker_ ? worker_->found() : nullptr;
  if (!read || read->faults == faults_reported_) return {};
  faults_reported_ = read->faults;
  return read->fault;
}

}  // namespace rocinante
