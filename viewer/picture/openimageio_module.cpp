#include "viewer/picture/openimageio_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "viewer/picture/exr_guard.h"
#include "viewer/picture/fine_picture.h"
#include "viewer/picture/memory_file.h"
#include "viewer/picture/srgb_curve.h"

namespace {

enum Answer : int32_t { read_whole = 0, no_picture = 1, too_large = 2, damaged = 3 };

void answer(RocinantePictureOut& out, Answer code, const std::string& sentence) {
  out.answer = code;
  const std::size_t length = std::min(sentence.size(), sizeof out.error - 1);
  std::memcpy(out.error, sentence.data(), length);
  out.error[length] = '\0';
}

/// The library's messages may have several lines.
std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The file's channels of red, green, blue and alpha (-1: none).
struct Channels {
  int red, green, blue, alpha;
};

/// Why a picture of this format is not read or judged; empty: it is.
std::string whyNot(const OIIO::ImageSpec& spec, bool to_judge) {
  if (spec.deep) return "has several samples per pixel (deep); only flat pictures are read";
  // TIFF 6.0: 5 separated inks, 8 to 10 kinds of CIELAB.
  const int tiff = spec.get_int_attribute("tiff:PhotometricInterpretation", 0);
  if (tiff >= 8 && tiff <= 10) return "has CIELAB colours; grey, RGB and CMYK are read";
  if (!to_judge) return "";
  // Different ink mixtures may look the same, but values are judged.
  if (tiff == 5 || spec.get_string_attribute("jpeg:ColorSpace") == "CMYK" ||
      spec.get_string_attribute("jpeg:ColorSpace") == "YCbCrK") {
    return "has CMYK colours; grey and RGB are judged";
  }
  const bool whole =
      spec.full_width == 0 || (spec.x == spec.full_x && spec.y == spec.full_y &&
                               spec.width == spec.full_width && spec.height == spec.full_height);
  return whole ? ""
               : "has a data window that differs from its display window; only whole pictures "
                 "are judged";
}

/// The library's GIF reader returns a channel past the last.
int alphaOf(const OIIO::ImageSpec& spec) {
  return std::min(spec.alpha_channel, spec.nchannels - 1);
}

Channels channelsOf(const OIIO::ImageSpec& spec) {
  const int alpha = alphaOf(spec);
  const bool grey = spec.nchannels - (alpha >= 0 ? 1 : 0) < 3;
  int colors[3] = {0, 0, 0};
  for (int channel = 0, found = 0; channel < spec.nchannels && found < (grey ? 1 : 3); ++channel) {
    if (channel != alpha) colors[found++] = channel;
  }
  if (grey) colors[1] = colors[2] = colors[0];
  return {colors[0], colors[1], colors[2], alpha};
}

/// A component as 8 bits, divided by `alpha` if the file has premultiplied alpha.
template <class T>
uint8_t byteOf(T value, T alpha, bool multiplied, const rocinante::SrgbCurve* curve);

template <>
uint8_t byteOf(uint8_t value, uint8_t alpha, bool multiplied, const rocinante::SrgbCurve*) {
  if (!multiplied || alpha == 255 || alpha == 0) return value;
  return static_cast<uint8_t>(std::min(255, (value * 255 + alpha / 2) / alpha));
}

template <>
uint8_t byteOf(uint16_t value, uint16_t alpha, bool multiplied, const rocinante::SrgbCurve*) {
  uint32_t straight = value;
  if (multiplied && alpha != 0) {
    straight = std::min<uint32_t>(65535, (straight * uint32_t{65535} + alpha / 2) / alpha);
  }
  return static_cast<uint8_t>(straight >> 8U);
}

template <>
uint8_t byteOf(float value, float alpha, bool multiplied, const rocinante::SrgbCurve* curve) {
  const float straight = multiplied && alpha > 0 ? value / alpha : value;
  if (curve != nullptr) return curve->encode(straight);
  return straight > 0 ? static_cast<uint8_t>(std::min(straight, 1.0F) * 255.0F + 0.5F) : uint8_t{0};
}

/// The file's values as RGBA floats; null without memory.
template <class T>
float* samplesOf(const std::vector<T>& content, std::size_t per_pixel, const Channels& channels,
                 float opaque) {
  const std::size_t pixels = content.size() / per_pixel;
  auto* samples = static_cast<float*>(std::malloc(pixels * 4 * sizeof(float)));
  if (samples == nullptr) return nullptr;
  for (std::size_t i = 0; i < pixels; ++i) {
    const T* pixel = content.data() + i * per_pixel;
    samples[i * 4] = static_cast<float>(pixel[channels.red]);
    samples[i * 4 + 1] = static_cast<float>(pixel[channels.green]);
    samples[i * 4 + 2] = static_cast<float>(pixel[channels.blue]);
    samples[i * 4 + 3] = channels.alpha < 0 ? opaque : static_cast<float>(pixel[channels.alpha]);
  }
  return samples;
}

/// The library silently fills missing parts of a JPEG with grey. In a complete file the end marker
/// follows the last scan.
bool jpegIsCut(const char* path, const void* bytes, size_t size) {
  std::string content;
  if (bytes == nullptr) {
    std::ifstream file(path, std::ios::binary);
    content.assign(std::istreambuf_iterator<char>(file), {});
  }
  const std::string_view jpeg = bytes == nullptr
                                    ? std::string_view(content)
                                    : std::string_view(static_cast<const char*>(bytes), size);
  const std::size_t end = jpeg.rfind("\xFF\xD9");
  const std::size_t scan = jpeg.rfind("\xFF\xDA");
  return end == jpeg.npos || (scan != jpeg.npos && end < scan);
}

std::string_view exrFaultOf(const char* path, const void* bytes, size_t size) {
  if (bytes != nullptr) {
    return rocinante::exrFault({static_cast<const char*>(bytes), size}, size);
  }
  std::string head(rocinante::kExrHeadBytes, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  file.seekg(0, std::ios::end);
  const std::streamoff end = file.tellg();
  return rocinante::exrFault(head, end < 0 ? head.size() : static_cast<std::uint64_t>(end));
}

template <class T>
bool readAs(OIIO::ImageInput& input, OIIO::TypeDesc type, bool with_samples,
            RocinantePictureOut& out) {
  const OIIO::ImageSpec& spec = input.spec();
  const std::size_t pixels =
      static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  const auto per_pixel = static_cast<std::size_t>(spec.nchannels);
  std::vector<T> content(pixels * per_pixel);
  if (!input.read_image(0, 0, 0, spec.nchannels, type, content.data())) return false;
  // PNG and TIFF mark straight alpha; otherwise the library assumes premultiplied.
  const Channels channels = channelsOf(spec);
  const bool multiplied =
      channels.alpha >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
  const bool linear = std::is_same_v<T, float> &&
                      spec.get_string_attribute("oiio:ColorSpace", "Linear") == "Linear";
  const rocinante::SrgbCurve curve;
  const rocinante::SrgbCurve* color_curve = linear ? &curve : nullptr;
  out.rgba = static_cast<uint8_t*>(std::malloc(pixels * 4));
  if (out.rgba == nullptr) return false;
  constexpr T kOpaque = std::is_same_v<T, float> ? T(1) : std::numeric_limits<T>::max();
  for (std::size_t i = 0; i < pixels; ++i) {
    const T* pixel = content.data() + i * per_pixel;
    uint8_t* to = out.rgba + i * 4;
    const T alpha = channels.alpha < 0 ? kOpaque : pixel[channels.alpha];
    to[0] = byteOf<T>(pixel[channels.red], alpha, multiplied, color_curve);
    to[1] = byteOf<T>(pixel[channels.green], alpha, multiplied, color_curve);
    to[2] = byteOf<T>(pixel[channels.blue], alpha, multiplied, color_curve);
    to[3] = byteOf<T>(alpha, kOpaque, false, nullptr);
  }
  if (with_samples && sizeof(T) > 1) {
    out.samples = samplesOf(content, per_pixel, channels, static_cast<float>(kOpaque));
    return out.samples != nullptr;
  }
  return true;
}

std::unique_ptr<OIIO::ImageInput> openJpeg(const void* bytes, size_t size) {
  rocinante::MemoryFile file;
  file.append(bytes, size);
  auto input = OIIO::ImageInput::create("jpg");
  OIIO::ImageSpec spec;
  if (input && !input->open(file.path(), spec)) input.reset();
  return input;
}

void read(const char* path, const void* bytes, size_t size, int64_t max_pixels, bool with_samples,
          RocinantePictureOut& out) {
  OIIO::ImageSpec wanted;
  wanted.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::Filesystem::IOMemReader memory(const_cast<void*>(bytes), size);  // it never writes
  if (const std::string_view fault = exrFaultOf(path, bytes, size); !fault.empty()) {
    return answer(out, damaged, std::string(fault));
  }
  const bool is_jpeg =
      size > 2 && std::string_view(static_cast<const char*>(bytes), 3) == "\xFF\xD8\xFF";
  const std::unique_ptr<OIIO::ImageInput> input =
      is_jpeg ? openJpeg(bytes, size)
              : OIIO::ImageInput::open(path, &wanted, bytes == nullptr ? nullptr : &memory);
  if (!input) {
    return answer(out, no_picture,
                  is_jpeg ? "is not a readable JPEG"
                          : "is not a readable picture: " + firstLine(OIIO::geterror()));
  }
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || spec.nchannels < 1) {
    return answer(out, no_picture, "is not a flat picture");
  }
  if (with_samples && spec.format.size() > 1) {
    max_pixels = std::min(max_pixels, rocinante::kMaxDeepPixels);
  }
  if (const std::string why = whyNot(spec, with_samples); !why.empty()) {
    return answer(out, no_picture, why);
  }
  // Refuse thousands of components, which would multiply the memory.
  if (int64_t{spec.width} * spec.height > max_pixels || spec.nchannels > 16) {
    return answer(out, too_large,
                  "is " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                      " pixels of " + std::to_string(spec.nchannels) + " components; at most " +
                      std::to_string(max_pixels) + " of 16 are read");
  }
  out.width = spec.width;
  out.height = spec.height;
  out.components = spec.nchannels;
  out.has_alpha = alphaOf(spec) >= 0 ? 1 : 0;
  out.bits = static_cast<int32_t>(spec.format.size() * 8);
  out.floating = spec.format.is_floating_point() ? 1 : 0;
  out.pictures = 1;
  out.orientation = spec.get_int_attribute("Orientation", 1);
  bool done = false;
  if (spec.format.is_floating_point()) {
    done = readAs<float>(*input, OIIO::TypeDesc::FLOAT, with_samples, out);
  } else if (spec.format.size() == 1) {
    done = readAs<uint8_t>(*input, OIIO::TypeDesc::UINT8, with_samples, out);
  } else {
    done = readAs<uint16_t>(*input, OIIO::TypeDesc::UINT16, with_samples, out);
  }
  if (!done) return answer(out, damaged, "cannot be decoded: " + firstLine(input->geterror()));
  if (std::strcmp(input->format_name(), "jpeg") == 0 && jpegIsCut(path, bytes, size)) {
    return answer(out, damaged, "is cut short");
  }
  if (with_samples && input->seek_subimage(1, 0)) out.pictures = 2;
  answer(out, read_whole, "");
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) int rocinante_picture_abi(void) {
  return ROCINANTE_PICTURE_ABI;
}

__attribute__((visibility("default"))) void rocinante_picture_read(const char* name,
                                                                   const void* bytes, size_t size,
                                                                   int64_t max_pixels,
                                                                   int32_t with_samples,
                                                                   RocinantePictureOut* out) {
  *out = {};
  try {
    read(name, bytes, size, max_pixels, with_samples != 0, *out);
  } catch (const std::exception& fault) {
    answer(*out, damaged, std::string("cannot be decoded: ") + fault.what());
  }
  if (out->answer != read_whole) {
    std::free(out->rgba);
    std::free(out->samples);
    out->rgba = nullptr;
    out->samples = nullptr;
  }
}

__attribute__((visibility("default"))) void rocinante_picture_free(void* memory) {
  std::free(memory);
}

}  // extern "C"
