#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// A file that somebody else is still writing, read beside them.
class FollowedFile {
 public:
  virtual ~FollowedFile() = default;

  /// How many bytes stand there now. An error when another file has taken its place.
  virtual Result<std::uint64_t> size() = 0;
  /// Fills `out` from `offset` on. An error when not all of it is there.
  virtual Status read(std::uint64_t offset, std::span<std::byte> out) = 0;

  virtual const std::string& name() const = 0;  ///< for messages to people
};

/// not_found or unreadable; a folder, a pipe or a device is unreadable. A file that is removed
/// while it is followed is followed on.
Result<std::unique_ptr<FollowedFile>> followFile(const std::filesystem::path& path);

}  // namespace rocinante
