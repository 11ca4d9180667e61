#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_types.h"

namespace rocinante {

class FollowedFile;

/// Reads a log while its recorder writes it: messages in the file's order, each once, as soon as
/// all of it is in the file, also from chunks still being written (docs/log-format.md, "The open
/// chunk"). Uses no clock: it returns what is there. Holds at most one chunk, and only until its
/// records are returned. Not for sharing between threads.
class LogFollower {
 public:
  enum class From {
    start,  ///< every message of the file
    now,    ///< messages not yet complete in the file when it is opened
  };

  /// not_found or unreadable when the file is; damaged when it does not start with the MCAP magic.
  /// An empty file is accepted: its recorder has just created it.
  static Result<LogFollower> open(const std::filesystem::path& path, From from);
  /// The same on any file.
  static Result<LogFollower> openOn(std::unique_ptr<FollowedFile> file, From from);

  ~LogFollower();
  LogFollower(LogFollower&&) noexcept;
  LogFollower& operator=(LogFollower&&) noexcept;

  /// The next message; its payload is valid until the next call, its channel as long as this
  /// object. Empty when there is none yet, or none any more: see ended(). Broken chunks are skipped
  /// and reported by takeDamage(). An error when reading cannot continue: the file was truncated or
  /// replaced, or its next bytes are not a record; every later call returns the same error.
  Result<std::optional<LogMessage>> poll();

  /// The recorder has closed the log, and every message was returned.
  bool ended() const;

  /// The start of the session, if the log has given it so far.
  std::optional<LogTime> origin() const;
  std::vector<DamageSpan> takeDamage();
  const std::string& name() const;

 private:
  struct Impl;
  explicit LogFollower(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
