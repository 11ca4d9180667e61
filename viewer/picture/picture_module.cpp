#include "viewer/picture/picture_module.h"

#include <dlfcn.h>

#include <cstdlib>
#include <memory>

#include "viewer/picture/openimageio_module.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModuleName = "librocinante_openimageio.so";

std::vector<fs::path> moduleFolders() {
  if (const char* chosen = std::getenv("ROCINANTE_MODULES"); chosen != nullptr && *chosen != '\0') {
    return {chosen};
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (program.empty()) return {};
  return {(program / "../lib").lexically_normal(),
          (program / ROCINANTE_MODULE_FOLDER).lexically_normal()};
}

/// The functions of a loaded module, or the reason that there are none. Never unloaded: OpenImageIO
/// keeps threads and caches until the process ends.
struct PictureModule {
  RocinantePictureRead read = nullptr;
  RocinantePictureFree free = nullptr;
  std::string reason;

  PictureModule() {
    std::string looked_in;
    for (const fs::path& folder : moduleFolders()) {
      const fs::path file = folder / kModuleName;
      std::error_code error;
      if (!fs::exists(file, error)) {
        looked_in += (looked_in.empty() ? "" : " or ") + folder.string();
        continue;
      }
      load(file);
      return;
    }
    reason = std::string(kModuleName) + " is not in " +
             (looked_in.empty() ? "any folder that is searched" : looked_in);
  }

 private:
  void load(const fs::path& file) {
    void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
      reason = std::string("it cannot be loaded: ") + ::dlerror();
      return;
    }
    const auto abi =
        reinterpret_cast<RocinantePictureAbi>(::dlsym(library, "rocinante_picture_abi"));
    const auto found_read =
        reinterpret_cast<RocinantePictureRead>(::dlsym(library, "rocinante_picture_read"));
    const auto found_free =
        reinterpret_cast<RocinantePictureFree>(::dlsym(library, "rocinante_picture_free"));
    if (abi == nullptr || abi() != ROCINANTE_PICTURE_ABI || found_read == nullptr ||
        found_free == nullptr) {
      reason = file.string() + " is of another version";
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

}  // namespace

Result<Picture> readByModule(const fs::path& path, std::int64_t max_pixels) {
  const PictureModule& module = pictureModule();
  if (module.read == nullptr) {
    return Error{ErrorKind::unsupported,
                 "only PNG is read without the OpenImageIO module; " + module.reason,
                 path.string()};
  }
  RocinantePictureOut out{};
  module.read(path.c_str(), max_pixels, &out);
  if (out.answer != 0) {
    return Error{out.answer == 3 ? ErrorKind::damaged : ErrorKind::unsupported, out.error,
                 path.string()};
  }
  const std::unique_ptr<std::uint8_t, RocinantePictureFree> rgba(out.rgba, module.free);
  const std::size_t bytes =
      std::size_t{4} * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height);
  return Picture{out.width, out.height, {out.rgba, out.rgba + bytes}};
}

}  // namespace rocinante
