#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>

#include "core/base/bytes.h"

namespace rocinante {

/// A folder of files that can be made again, each named after the 32 hexadecimal digits of its key.
/// Never fails: write errors are ignored. Several threads and processes may use one folder at a
/// time; files appear whole. Other files in it are never touched.
class CacheFolder {
 public:
  /// Keeps nothing.
  CacheFolder() = default;
  /// Deletes the least recently used files when they take more than `most_bytes`. `ending` is that
  /// of the files, with its point.
  CacheFolder(std::filesystem::path folder, std::string ending, std::uint64_t most_bytes)
      : folder_(std::move(folder)), ending_(std::move(ending)), most_bytes_(most_bytes) {}

  /// XDG_CACHE_HOME/rocinante/NAME, else HOME/.cache/rocinante/NAME; empty if neither is an
  /// absolute path.
  static std::filesystem::path ofUser(const std::string& name);

  /// Empty: nothing is kept.
  const std::filesystem::path& path() const { return folder_; }
  std::uint64_t mostBytes() const { return most_bytes_; }

  std::filesystem::path fileOf(const std::string& key) const { return folder_ / (key + ending_); }
  /// Marks the file as recently used. Fails harmlessly in a read-only folder.
  void touch(const std::string& key) const;
  void store(const std::string& key, ByteView bytes) const { store(key, {bytes}); }
  /// A file of these, one behind another.
  void store(const std::string& key, std::initializer_list<ByteView> parts) const;

 private:
  bool isOurs(const std::filesystem::path& file) const;
  void makeRoom(std::uint64_t bytes) const;

  std::filesystem::path folder_;
  std::string ending_;
  std::uint64_t most_bytes_ = 0;
};

}  // namespace rocinante
