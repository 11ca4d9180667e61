#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// Reads a whole file into memory: at most `max_bytes`, checked before anything is allocated.
Result<std::string> readFile(const std::filesystem::path& path,
                             std::uint64_t max_bytes = std::uint64_t{1} << 31);

/// Hands over a file in parts of at most 256 KiB, which are gone after the call: where all of it in
/// memory at once would cost more than what is done with it. `size` is what the file had at
/// opening. Stops at the first refusal of `take`, and returns it.
Status readFileInParts(const std::filesystem::path& path, std::uint64_t max_bytes,
                       const std::function<Status(ByteView part, std::uint64_t size)>& take);

/// When the bytes must be on the disk: once writeFileWhole() returns, or, for many small files that
/// can be regenerated, once syncFileSystem() does. Until then a reader sees the file whole, even if
/// the program was killed, but perhaps not after a power cut.
enum class Sync { now, later };

/// Writes beside `path`, syncs and renames: the file appears whole or not at all. refused when it
/// exists, or came meanwhile, and `overwrite` is false; is not a regular file (a device would be
/// replaced), or is a log that another process is writing (core/base/file_lock.h).
Status writeFileWhole(const std::filesystem::path& path, ByteView bytes, bool overwrite,
                      Sync sync = Sync::now);

/// Whether writeFileWhole() could begin: call it before the work whose result it will write.
Status mayWriteFile(const std::filesystem::path& path, bool overwrite);

/// Waits until everything written to the file system of `folder` is on the disk.
Status syncFileSystem(const std::filesystem::path& folder);

}  // namespace rocinante
