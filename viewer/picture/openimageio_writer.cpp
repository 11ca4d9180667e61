// rocinante_picture_write of the module.

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/picture/memory_file.h"
#include "viewer/picture/openimageio_module.h"
#include "viewer/picture/srgb_curve.h"

namespace {

enum Outcome : int32_t { encoded = 0, unknown_ending = 1, failed = 2 };

void conclude(RocinantePictureEncoded& out, Outcome outcome, const std::string& sentence) {
  out.answer = outcome;
  const std::string line = sentence.substr(0, sentence.find('\n'));
  const std::size_t length = std::min(line.size(), sizeof out.error - 1);
  std::memcpy(out.error, line.data(), length);
  out.error[length] = '\0';
}

/// Formats whose numbers are linear light.
bool isLinear(const OIIO::ImageOutput& output) {
  const std::string format = output.format_name();
  return format == "openexr" || format == "hdr";
}

bool isOpaque(const uint8_t* rgba, std::size_t pixels) {
  for (std::size_t i = 0; i < pixels; ++i) {
    if (rgba[i * 4 + 3] != 255) return false;
  }
  return true;
}

/// Display values as linear light, premultiplied as such formats have them.
std::vector<float> linearPixels(const uint8_t* rgba, std::size_t pixels, int channels) {
  float levels[256];
  for (int level = 0; level < 256; ++level) levels[level] = rocinante::SrgbCurve::decode(level);
  std::vector<float> light;
  light.reserve(pixels * static_cast<std::size_t>(channels));
  for (std::size_t i = 0; i < pixels; ++i) {
    const uint8_t* pixel = rgba + i * 4;
    const float alpha = static_cast<float>(pixel[3]) / 255.0F;
    for (int c = 0; c < 3; ++c) light.push_back(levels[pixel[c]] * alpha);
    if (channels == 4) light.push_back(alpha);
  }
  return light;
}

std::vector<uint8_t> bytePixels(const uint8_t* rgba, std::size_t pixels, int channels) {
  const auto width = static_cast<std::size_t>(channels);
  std::vector<uint8_t> bytes(pixels * width);
  for (std::size_t i = 0; i < pixels; ++i) {
    std::copy_n(rgba + i * 4, width, bytes.data() + i * width);
  }
  return bytes;
}

void describe(const RocinantePictureIn& in, const OIIO::ImageOutput& output,
              OIIO::ImageSpec& spec) {
  // A TIFF has a time in any case: not that of writing, so that the same picture is the same file.
  if (output.format_name() == std::string_view("tiff")) {
    spec.attribute("DateTime", "1970:01:01 00:00:00");
  }
  for (int32_t i = 0; i + 1 < in.text_count; i += 2) spec.attribute(in.text[i], in.text[i + 1]);
  if (in.kind == 0) {
    // JPEG at 95 without subsampling keeps thin lines and text; WebP at 95 is alike.
    spec.attribute("CompressionQuality", 95);
    spec.attribute("jpeg:subsampling", "4:4:4");
    spec.attribute("oiio:UnassociatedAlpha", 1);
  } else {
    spec.channelnames.assign(1, in.channel);
  }
}

bool put(OIIO::ImageOutput& output, const std::string& path, const RocinantePictureIn& in) {
  const std::size_t pixels =
      static_cast<std::size_t>(in.width) * static_cast<std::size_t>(in.height);
  if (in.kind != 0) {
    const OIIO::TypeDesc type = in.kind == 1 ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT32;
    OIIO::ImageSpec spec(in.width, in.height, 1, type);
    describe(in, output, spec);
    return output.open(path, spec) && output.write_image(type, in.pixels) && output.close();
  }
  const auto* rgba = static_cast<const uint8_t*>(in.pixels);
  const int channels = isOpaque(rgba, pixels) || !output.supports("alpha") ? 3 : 4;
  if (isLinear(output)) {
    OIIO::ImageSpec spec(in.width, in.height, channels, OIIO::TypeDesc::HALF);
    describe(in, output, spec);
    spec.erase_attribute("oiio:UnassociatedAlpha");
    const std::vector<float> light = linearPixels(rgba, pixels, channels);
    return output.open(path, spec) && output.write_image(OIIO::TypeDesc::FLOAT, light.data()) &&
           output.close();
  }
  OIIO::ImageSpec spec(in.width, in.height, channels, OIIO::TypeDesc::UINT8);
  describe(in, output, spec);
  const std::vector<uint8_t> bytes = bytePixels(rgba, pixels, channels);
  return output.open(path, spec) && output.write_image(OIIO::TypeDesc::UINT8, bytes.data()) &&
         output.close();
}

void write(const char* name, const RocinantePictureIn& in, RocinantePictureEncoded& out) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(name);
  if (!output) {
    static_cast<void>(OIIO::geterror());
    return conclude(out, unknown_ending, "no picture format with this ending is written");
  }
  if (in.pixels == nullptr) return;
  const rocinante::MemoryFile file;
  if (!put(*output, file.path(), in)) {
    return conclude(out, failed, "cannot be encoded: " + output->geterror());
  }
  out.bytes = file.takeBytes(out.size);
  if (out.bytes == nullptr) conclude(out, failed, "not enough memory to encode");
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void rocinante_picture_write(
    const char* name, const RocinantePictureIn* in, RocinantePictureEncoded* out) {
  *out = {};
  try {
    write(name, *in, *out);
  } catch (const std::exception& fault) {
    conclude(*out, failed, std::string("cannot be encoded: ") + fault.what());
  }
}
