#include "viewer/picture/picture_module.h"

#include <cmath>

#include "core/base/loaded_module.h"
#include "viewer/picture/openimageio_module.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModuleName = "librocinante_openimageio.so";

/// The functions of a loaded module, or the reason why it is not loaded.
struct PictureModule {
  RocinantePictureRead read = nullptr;
  RocinantePictureFree free = nullptr;
  RocinantePictureWrite write = nullptr;
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
    const auto found_write =
        reinterpret_cast<RocinantePictureWrite>(functionOf(library, "rocinante_picture_write"));
    if (abi == nullptr || abi() != ROCINANTE_PICTURE_ABI || found_read == nullptr ||
        found_free == nullptr || found_write == nullptr) {
      reason = std::string(kModuleName) + " has a different version";
      return;
    }
    read = found_read;
    free = found_free;
    write = found_write;
  }
};

const PictureModule& pictureModule() {
  static const PictureModule module;
  return module;
}

/// The module's answer; owns its memory.
struct ModuleAnswer {
  RocinantePictureOut out{};
  RocinantePictureFree free = nullptr;

  ModuleAnswer() = default;
  ModuleAnswer(const ModuleAnswer&) = delete;
  ModuleAnswer& operator=(const ModuleAnswer&) = delete;
  ~ModuleAnswer() {
    if (free == nullptr) return;
    free(out.rgba);
    free(out.samples);
  }
  std::size_t size() const {
    return std::size_t{4} * static_cast<std::size_t>(out.width) *
           static_cast<std::size_t>(out.height);
  }
  Picture picture() const { return {out.width, out.height, {out.rgba, out.rgba + size()}}; }
};

Status askModule(const char* file, ByteView bytes, const std::string& name, std::int64_t max_pixels,
                 bool with_samples, ModuleAnswer& answer) {
  const PictureModule& module = pictureModule();
  if (module.read == nullptr) {
    return Error{
        ErrorKind::unsupported,
        "only PNG is read without the OpenImageIO module (package rocinante-openimageio); " +
            module.reason,
        name};
  }
  answer.free = module.free;
  module.read(file, bytes.data(), bytes.size(), max_pixels, with_samples ? 1 : 0, &answer.out);
  if (answer.out.answer != 0) {
    return Error{answer.out.answer == 3 ? ErrorKind::damaged : ErrorKind::unsupported,
                 answer.out.error, name};
  }
  return {};
}

/// Data of the file that would not be judged; empty: none.
std::string unjudged(const RocinantePictureOut& out) {
  if (out.pictures > 1) return "has several pictures; only files with one picture are judged";
  // A fourth component other than alpha (depth, an ink) would be ignored.
  const int colors = out.components - out.has_alpha;
  if (colors != 1 && colors != 3) {
    return "holds " + std::to_string(out.components) +
           " components; grey, RGB and alpha are judged";
  }
  if (out.bits > (out.floating != 0 ? 32 : 16)) {
    return "holds numbers of " + std::to_string(out.bits) + " bits; at most " +
           (out.floating != 0 ? "32" : "16") + " are judged";
  }
  return "";
}

void countNotFinite(FinePicture& fine) {
  for (std::size_t i = 0; i < fine.samples.size(); ++i) {
    if (std::isfinite(fine.samples[i])) continue;
    if (fine.not_finite++ > 0) continue;
    const auto width = static_cast<std::size_t>(fine.picture.width);
    fine.not_finite_x = static_cast<int>(i / 4 % width);
    fine.not_finite_y = static_cast<int>(i / 4 / width);
  }
}

/// Asks the module to encode; without pixels, whether it could.
Result<Bytes> encode(const std::string& name, const RocinantePictureIn& in) {
  const PictureModule& module = pictureModule();
  if (module.write == nullptr) {
    return Error{
        ErrorKind::unsupported,
        "only PNG is written without the OpenImageIO module (package rocinante-openimageio); " +
            module.reason,
        name};
  }
  RocinantePictureEncoded out{};
  module.write(name.c_str(), &in, &out);
  if (out.answer != 0) {
    return Error{out.answer == 1 ? ErrorKind::unsupported : ErrorKind::refused, out.error, name};
  }
  const auto* first = static_cast<const std::byte*>(out.bytes);
  Bytes bytes(first, first + out.size);
  module.free(out.bytes);
  return bytes;
}

}  // namespace

Result<Bytes> encodeByModule(const std::string& name, const Picture& picture) {
  RocinantePictureIn in{};
  in.width = picture.width;
  in.height = picture.height;
  in.pixels = picture.rgba.data();
  return encode(name, in);
}

Result<Bytes> encodeByModule(const std::string& name, const MeasuredPicture& picture) {
  std::vector<const char*> text;
  for (const std::string& word : picture.text) text.push_back(word.c_str());
  RocinantePictureIn in{};
  in.width = picture.width;
  in.height = picture.height;
  in.kind = picture.floats.empty() ? 2 : 1;
  in.pixels = picture.floats.empty() ? static_cast<const void*>(picture.numbers.data())
                                     : static_cast<const void*>(picture.floats.data());
  in.channel = picture.channel.c_str();
  in.text = text.data();
  in.text_count = static_cast<std::int32_t>(text.size());
  return encode(name, in);
}

Status mayEncodeByModule(const std::string& name) {
  const Result<Bytes> asked = encode(name, RocinantePictureIn{});
  return asked ? Status{} : Status{asked.error()};
}

Result<Picture> readByModule(const fs::path& path, std::int64_t max_pixels) {
  ModuleAnswer answer;
  const Status read = askModule(path.c_str(), {}, path.string(), max_pixels, false, answer);
  if (!read.ok()) return read.error();
  return answer.picture();
}

Result<FinePicture> readFineByModule(const fs::path& path, std::int64_t max_pixels) {
  ModuleAnswer answer;
  const Status read = askModule(path.c_str(), {}, path.string(), max_pixels, true, answer);
  if (!read.ok()) return read.error();
  if (const std::string why = unjudged(answer.out); !why.empty()) {
    return Error{ErrorKind::unsupported, why, path.string()};
  }
  FinePicture fine;
  fine.picture = answer.picture();
  fine.encoding = {answer.out.components, answer.out.bits, answer.out.floating != 0};
  fine.orientation = answer.out.orientation;
  if (answer.out.samples != nullptr) {
    fine.samples.assign(answer.out.samples, answer.out.samples + answer.size());
    countNotFinite(fine);
  }
  return fine;
}

Result<Picture> decodeByModule(ByteView bytes, const std::string& name, std::int64_t max_pixels) {
  // The library tries the extension first, then the content.
  ModuleAnswer answer;
  const Status read = askModule("picture.png", bytes, name, max_pixels, false, answer);
  if (!read.ok()) return read.error();
  return answer.picture();
}

}  // namespace rocinante
