#include "viewer/picture/picture.h"

#include <xxhash.h>

#include <array>
#include <fstream>
#include <memory>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "viewer/picture/fine_picture.h"
#include "viewer/picture/lfs_pointer.h"
#include "viewer/picture/picture_module.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxPipedBytes = std::uint64_t{1} << 30U;
constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1A\n";

/// Whether the file is a PNG by its content, not its name.
Result<bool> isPng(const std::filesystem::path& path) {
  std::error_code fault;
  const auto status = std::filesystem::status(path, fault);
  if (!std::filesystem::exists(status)) {
    return Error{ErrorKind::not_found, "the picture does not exist", path.string()};
  }
  if (std::filesystem::is_directory(status)) {
    return Error{ErrorKind::unreadable, "is a folder, not a picture", path.string()};
  }
  if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status)) {
    return Error{ErrorKind::unreadable, "is a device, not a picture", path.string()};
  }
  std::ifstream file(path, std::ios::binary);
  char bytes[1024] = {};
  file.read(bytes, sizeof bytes);
  const std::string_view first(bytes, static_cast<std::size_t>(file.gcount()));
  if (first.empty() && file.eof()) {
    return Error{ErrorKind::unreadable, "is an empty file", path.string()};
  }
  if (first.size() < kPngSignature.size()) {
    return Error{ErrorKind::unreadable, "is not a readable picture", path.string()};
  }
  if (isLfsPointer(bytesOf(first))) {
    return Error{ErrorKind::unsupported,
                 "is a Git LFS pointer, not the picture; `git lfs pull` fetches it", path.string()};
  }
  return first.starts_with(kPngSignature);
}

/// A pipe can only be read once.
bool isPipe(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_fifo(path, ignored);
}

/// The PNG from a pipe: the module can only read files.
Result<std::string> pngFromPipe(const std::filesystem::path& path) {
  auto content = readFile(path, kMaxPipedBytes);
  if (!content.ok() || content->starts_with(kPngSignature)) return content;
  return Error{ErrorKind::unsupported, "only PNG can be read from a pipe", path.string()};
}

}  // namespace

Result<Picture> readPicture(const std::filesystem::path& path, std::int64_t max_pixels) {
  if (isPipe(path)) {
    const Result<std::string> content = pngFromPipe(path);
    if (!content.ok()) return content.error();
    return decodePng(bytesOf(*content), path.string(), max_pixels);
  }
  const Result<bool> png = isPng(path);
  if (!png.ok()) return png.error();
  return *png ? readPng(path, max_pixels) : readByModule(path, max_pixels);
}

Result<Picture> decodePicture(ByteView bytes, const std::string& name, std::int64_t max_pixels) {
  const bool png = textOf(bytes).starts_with(kPngSignature);
  return png ? decodePng(bytes, name, max_pixels) : decodeByModule(bytes, name, max_pixels);
}

Result<FinePicture> readFinePicture(const std::filesystem::path& path, std::int64_t max_pixels) {
  const bool is_pipe = isPipe(path);
  if (!is_pipe) {
    const Result<bool> png = isPng(path);
    if (!png.ok()) return png.error();
    if (!*png) return readFineByModule(path, max_pixels);
  }
  const Result<std::string> content = is_pipe ? pngFromPipe(path) : readFile(path);
  if (!content.ok()) return content.error();
  return decodeFinePng(bytesOf(*content), path.string(), max_pixels);
}

std::string PictureEncoding::depthText() const {
  return floating ? std::to_string(bits) + "-bit floating point"
                  : std::to_string(bits) + " bits per component";
}

std::string_view PictureEncoding::componentsText() const {
  constexpr std::string_view kNames[] = {"grey", "grey with alpha", "RGB", "RGBA"};
  return kNames[components - 1];
}

std::string pictureSha256(const Picture& picture) {
  Sha256 hash;
  hash.add(picture.bytes());
  return hexOf(hash.finish());
}

std::string pictureXxh3(const Picture& picture) {
  std::array<std::uint8_t, 8> size{};
  const auto width = static_cast<std::uint32_t>(picture.width);
  const auto height = static_cast<std::uint32_t>(picture.height);
  for (unsigned i = 0; i < 4; ++i) {
    size[i] = static_cast<std::uint8_t>(width >> (8 * i));
    size[4 + i] = static_cast<std::uint8_t>(height >> (8 * i));
  }
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(),
                                                                              XXH3_freeState);
  XXH3_128bits_reset(state.get());
  XXH3_128bits_update(state.get(), size.data(), size.size());
  XXH3_128bits_update(state.get(), picture.rgba.data(), picture.rgba.size());
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state.get()));
  return hexOf(std::as_bytes(std::span(canonical.digest)));
}

}  // namespace rocinante
