#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rocinante::decode {

/// The descriptor files that a declaration names (docs/decoders.md, "protobuf"), each read once.
class DescriptorFiles {
 public:
  struct File {
    std::string name;  ///< as the declaration writes it: relative, below its folder
    std::string bytes;
  };

  /// Of the declaration `file`, which needs not exist.
  explicit DescriptorFiles(std::filesystem::path file) : file_(std::move(file)) {}

  /// The bytes of a file; they live as long as this. bad_argument for a name that leads elsewhere.
  Result<std::string_view> read(const std::string& name);
  /// In the order of their first read().
  const std::deque<File>& files() const { return files_; }

 private:
  std::filesystem::path file_;
  std::deque<File> files_;
};

/// Where the descriptor `name` of the declaration `file` lies: beside it or, as `log extract` lays
/// them out, in the folder that is called as the declaration without its ending.
std::filesystem::path descriptorPath(const std::filesystem::path& file, const std::string& name);

}  // namespace rocinante::decode
