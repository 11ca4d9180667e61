#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// A file read while another process writes it.
class FollowedFile {
 public:
  virtual ~FollowedFile() = default;

  /// The current size in bytes. An error when another file has replaced this one.
  virtual Result<std::uint64_t> size() = 0;
  /// Fills `out` from `offset` on. An error when the file has fewer bytes.
  virtual Status read(std::uint64_t offset, std::span<std::byte> out) = 0;

  virtual const std::string& name() const = 0;  ///< for messages to users
};

/// not_found or unreadable; a folder, a pipe or a device is unreadable. A file that is removed
/// while it is followed can still be read.
Result<std::unique_ptr<FollowedFile>> followFile(const std::filesystem::path& path);

}  // namespace rocinante
