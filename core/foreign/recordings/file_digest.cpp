#include "core/foreign/recordings/file_digest.h"

#include <algorithm>

#include "core/log/mapped_file.h"

namespace rocinante {
namespace {

constexpr std::size_t kPartBytes = std::size_t{1} << 20;

}  // namespace

Status addFile(Sha256& hash, const std::filesystem::path& path, const DigestProgress& progress) {
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file) return file.error();
  const std::size_t size = file->bytes().size();
  hash.addU64(size);
  Bytes part(std::min(size, kPartBytes));
  for (std::size_t from = 0; from < size; from += part.size()) {
    if (progress) {
      const double done = static_cast<double>(from) / static_cast<double>(size);
      if (Status goes_on = progress(done); !goes_on) return goes_on;
    }
    part.resize(std::min(size - from, kPartBytes));
    if (!file->read(from, part)) {
      return Error{ErrorKind::unreadable, "the file cannot be read", path.string()};
    }
    hash.add(part);
  }
  return {};
}

Result<std::string> quickSumOf(const std::filesystem::path& path) {
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file) return file.error();
  const std::size_t size = file->bytes().size();
  Sha256 sum;
  Bytes part(std::min(size, kPartBytes));
  for (std::size_t from = 0; from < size; from += part.size()) {
    part.resize(std::min(size - from, kPartBytes));
    if (!file->read(from, part)) {
      return Error{ErrorKind::unreadable, "the file cannot be read", path.string()};
    }
    sum.add(xxh3(part));
  }
  return std::to_string(size) + " " + hexOf(sum.finish()) + "\n";
}

}  // namespace rocinante
