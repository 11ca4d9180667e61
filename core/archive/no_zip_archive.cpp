#include "core/archive/zip_archive.h"

namespace rocinante {
namespace {

Error withoutLibzip(const std::string& file) {
  return {ErrorKind::unsupported,
          "this build has no libzip to read ZIP files; unpack it, and give the folder", file};
}

}  // namespace

struct ZipArchive::Handle {};

ZipArchive::~ZipArchive() = default;
ZipArchive::ZipArchive(ZipArchive&&) noexcept = default;

Result<ZipArchive> ZipArchive::open(const std::filesystem::path& path) {
  return withoutLibzip(path.string());
}

Result<ZipArchive> ZipArchive::ofBytes(ByteView /*bytes*/, const std::string& file) {
  return withoutLibzip(file);
}

Result<std::string> ZipArchive::read(const std::string& /*name*/,
                                     std::uint64_t /*most_bytes*/) const {
  return withoutLibzip(file_);
}

}  // namespace rocinante
