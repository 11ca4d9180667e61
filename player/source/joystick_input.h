#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/base/time.h"
#include "player/source/joystick_drive.h"

namespace rocinante {

/// The events of a joystick (/dev/input/jsN), or of a file that holds such events and is read with
/// their own spacing. Moments are nanoseconds since the joystick was opened, or since the file's
/// first event. One thread; nothing waits.
class JoystickInput {
 public:
  /// not_found or refused when it cannot be opened; bad_argument for a folder.
  static Result<JoystickInput> open(const std::filesystem::path& path);

  /// The next event that is due at `now`; empty: none is. damaged with its place for bytes that are
  /// no event, unreadable when the joystick was unplugged.
  Result<std::optional<JoystickEvent>> next(Nanoseconds now);

  /// When the event happened that next() has returned last; of a device: when it was read.
  Nanoseconds moment() const { return moment_; }
  /// When a file's next event is due; a device's are told by its descriptor.
  Nanoseconds nextMoment() const;
  /// The whole of a file has been returned.
  bool ended() const { return ended_ && filled_ == 0; }
  /// For poll(); -1: of a file, for whose events there is nothing to wait.
  int descriptor() const { return is_file_ ? -1 : file_.get(); }

 private:
  /// Closed with its owner.
  class File {
   public:
    explicit File(int descriptor) : descriptor_(descriptor) {}
    File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    File& operator=(File&&) = delete;
    ~File();
    int get() const { return descriptor_; }

   private:
    int descriptor_;
  };

  JoystickInput(std::string path, File file, bool is_file)
      : path_(std::move(path)), file_(std::move(file)), is_file_(is_file) {}

  Status fill();
  std::optional<JoystickEvent> held() const;

  std::string path_;
  File file_;
  bool is_file_;
  bool ended_ = false;
  std::array<std::byte, JoystickEvent::kBytes> bytes_{};  ///< of the next event
  std::size_t filled_ = 0;                                ///< of them
  std::uint64_t returned_ = 0;                            ///< events
  std::optional<std::uint32_t> first_ms_;
  Nanoseconds moment_{};
};

}  // namespace rocinante
