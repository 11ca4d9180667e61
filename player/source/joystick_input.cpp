#include "player/source/joystick_input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <span>

namespace rocinante {

JoystickInput::File::~File() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<JoystickInput> JoystickInput::open(const std::filesystem::path& path) {
  File file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0) {
    const ErrorKind kind = errno == ENOENT ? ErrorKind::not_found : ErrorKind::refused;
    return Error{kind, std::strerror(errno), path.string()};
  }
  if (S_ISDIR(status.st_mode)) {
    return Error{ErrorKind::bad_argument, "a joystick is /dev/input/jsN, not a folder",
                 path.string()};
  }
  return JoystickInput(path.string(), std::move(file), S_ISREG(status.st_mode));
}

Status JoystickInput::fill() {
  while (filled_ < bytes_.size() && !ended_) {
    const ssize_t got = ::read(file_.get(), bytes_.data() + filled_, bytes_.size() - filled_);
    if (got > 0) {
      filled_ += static_cast<std::size_t>(got);
    } else if (got == 0) {
      ended_ = true;
    } else if (errno == EAGAIN) {
      break;
    } else if (errno == ENODEV) {
      return Error{ErrorKind::unreadable, "the joystick was unplugged", path_};
    } else if (errno != EINTR) {
      return Error{ErrorKind::unreadable, std::strerror(errno), path_};
    }
  }
  if (!ended_ || filled_ == 0 || filled_ == bytes_.size()) return {};
  const std::size_t rest = std::exchange(filled_, 0);
  return Error{ErrorKind::damaged, "ends within an event, " + std::to_string(rest) + " of 8 bytes",
               path_ + ", byte " + std::to_string(returned_ * bytes_.size())};
}

/// The event whose bytes are there.
std::optional<JoystickEvent> JoystickInput::held() const {
  if (filled_ < bytes_.size()) return std::nullopt;
  return JoystickEvent::read(std::span(bytes_));
}

Nanoseconds JoystickInput::nextMoment() const {
  const auto event = held();
  if (!is_file_ || !event) return Nanoseconds::max();
  // The driver's clock wraps after 49 days: only differences count.
  const std::uint32_t since = event->time_ms - first_ms_.value_or(event->time_ms);
  return std::max(moment_, Nanoseconds(std::chrono::milliseconds(since)));
}

Result<std::optional<JoystickEvent>> JoystickInput::next(Nanoseconds now) {
  if (const Status filled = fill(); !filled) return filled.error();
  if (filled_ < bytes_.size()) return std::optional<JoystickEvent>();
  const std::optional<JoystickEvent> event = held();
  if (!event) {
    return Error{ErrorKind::damaged, "holds no joystick event; a joystick is /dev/input/jsN",
                 path_ + ", byte " + std::to_string(returned_ * bytes_.size())};
  }
  if (is_file_ && nextMoment() > now) return std::optional<JoystickEvent>();
  moment_ = is_file_ ? nextMoment() : now;
  if (!first_ms_) first_ms_ = event->time_ms;
  ++returned_;
  filled_ = 0;
  return event;
}

}  // namespace rocinante
