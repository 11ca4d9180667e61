#include "viewer/picture/picture_module.h"

#include <memory>

#include "core/loaded_module.h"
#include "viewer/picture/openimageio_module.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModuleName = "librocinante_openimageio.so";

/// The functions of a loaded module, or the reason that there are none.
struct PictureModule {
  RocinantePictureRead read = nullptr;
  RocinantePictureFree free = nullptr;
  std::string reason;

  PictureModule() {
    const Result<void*> loaded = loadModule(kModuleName);
    if (!loaded.ok()) {
      reason = loaded.error().what;
      return;
    }
    void* library = *loaded;
    const auto abi =
        reinterpret_cast<RocinantePictureAbi>(functionOf(library, "rocinante_picture_abi"));
    const auto found_read =
        reinterpret_cast<RocinantePictureRead>(functionOf(library, "rocinante_picture_read"));
    const auto found_free =
        reinterpret_cast<RocinantePictureFree>(functionOf(library, "rocinante_picture_free"));
    if (abi == nullptr || abi() != ROCINANTE_PICTURE_ABI || found_read == nullptr ||
        found_free == nullptr) {
      reason = std::string(kModuleName) + " is of another version";
      return;
    }
    read = found_read;
    free = found_free;
  }
};

const PictureModule& pictureModule() {
  static const PictureModule module;
  return module;
}

Result<Picture> askModule(const char* file, ByteView bytes, const std::string& name,
                          std::int64_t max_pixels) {
  const PictureModule& module = pictureModule();
  if (module.read == nullptr) {
    return Error{ErrorKind::unsupported,
                 "only PNG is read without the OpenImageIO module; " + module.reason, name};
  }
  RocinantePictureOut out{};
  module.read(file, bytes.data(), bytes.size(), max_pixels, &out);
  if (out.answer != 0) {
    return Error{out.answer == 3 ? ErrorKind::damaged : ErrorKind::unsupported, out.error, name};
  }
  const std::unique_ptr<std::uint8_t, RocinantePictureFree> rgba(out.rgba, module.free);
  const std::size_t size =
      std::size_t{4} * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height);
  return Picture{out.width, out.height, {out.rgba, out.rgba + size}};
}

}  // namespace

Result<Picture> readByModule(const fs::path& path, std::int64_t max_pixels) {
  return askModule(path.c_str(), {}, path.string(), max_pixels);
}

Result<Picture> decodeByModule(ByteView bytes, const std::string& name, std::int64_t max_pixels) {
  // The module goes by endings; what else than JPEG stands in mesh files it tells by the bytes.
  const bool is_jpeg = textOf(bytes).starts_with("\xFF\xD8\xFF");
  return askModule(is_jpeg ? "picture.jpg" : "picture.png", bytes, name, max_pixels);
}

}  // namespace rocinante
