#include "core/foreign/decode/descriptor_files.h"

#include <algorithm>

#include "core/base/atomic_file.h"

namespace rocinante::decode {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxDescriptorBytes = std::size_t{4} << 20U;
constexpr std::size_t kMaxDescriptors = 16;

bool isBelow(const fs::path& name) {
  return !name.empty() && name.is_relative() && name.has_filename() &&
         std::ranges::none_of(name, [](const fs::path& each) { return each == ".."; });
}

}  // namespace

fs::path descriptorPath(const fs::path& file, const std::string& name) {
  const fs::path beside = file.parent_path() / name;
  const fs::path laid_out = file.parent_path() / file.stem() / name;
  std::error_code error;
  return !fs::exists(beside, error) && fs::exists(laid_out, error) ? laid_out : beside;
}

Result<std::string_view> DescriptorFiles::read(const std::string& name) {
  const auto known = std::ranges::find(files_, name, &File::name);
  if (known != files_.end()) return std::string_view(known->bytes);
  if (!isBelow(name)) {
    return Error{ErrorKind::bad_argument,
                 "a descriptor lies in the folder of its declaration, or below it",
                 {}};
  }
  if (files_.size() == kMaxDescriptors) {
    return Error{ErrorKind::bad_argument, "a declaration has at most 16 descriptors", {}};
  }
  Result<std::string> bytes = readFile(descriptorPath(file_, name), kMaxDescriptorBytes);
  if (!bytes) return bytes.error();
  return std::string_view(files_.emplace_back(File{name, std::move(*bytes)}).bytes);
}

}  // namespace rocinante::decode
