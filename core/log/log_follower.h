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

/// Reads a log beside its recorder: messages in the file's order, each once, as soon as the whole
/// of it stands in the file; chunks that are still being written too (docs/log-format.md, "The open
/// chunk"). Knows no clock: it answers what is there. Holds at most one chunk, as far as its
/// records have not been given. Not for sharing between threads.
class LogFollower {
 public:
  enum class From {
    start,  ///< every message of the file
    now,    ///< those that are not whole in the file when it is opened
  };

  /// not_found or unreadable when the file is; damaged when it begins as no log does. An empty file
  /// is one: its recorder has only just made it.
  static Result<LogFollower> open(const std::filesystem::path& path, From from);
  /// The same on any file.
  static Result<LogFollower> openOn(std::unique_ptr<FollowedFile> file, From from);

  ~LogFollower();
  LogFollower(LogFollower&&) noexcept;
  LogFollower& operator=(LogFollower&&) noexcept;

  /// The next message; its payload is valid until the next call, its channel as long as this. Empty
  /// when there is none yet, or never again: see ended(). Chunks that are broken are left out and
  /// told by takeDamage(). An error when it cannot go on: the file was made shorter or replaced, or
  /// what stands there is no record; every later call answers the same.
  Result<std::optional<LogMessage>> poll();

  /// The log's recorder has closed it, and everything was given.
  bool ended() const;

  /// When the session began, as far as the log has said so.
  std::optional<LogTime> origin() const;
  std::vector<DamageSpan> takeDamage();
  const std::string& name() const;

 private:
  struct Impl;
  explicit LogFollower(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
