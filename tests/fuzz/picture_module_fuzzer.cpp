// What the OpenImageIO module makes of any bytes: the first one says whether a judge or a texture
// asks. The module is part of the program here; the library below it is the system's, without
// sanitizers.
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "viewer/picture/openimageio_module.h"

extern "C" {
void rocinante_picture_read(const char*, const void*, size_t, int64_t, int32_t,
                            RocinantePictureOut*);
void rocinante_picture_free(void*);
}

namespace {

void require(bool sound) {
  if (!sound) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  RocinantePictureOut out{};
  rocinante_picture_read("picture.png", data + 1, size - 1, 1 << 16, data[0] % 2, &out);
  if (out.answer == 0) {
    require(out.width > 0 && out.height > 0 && out.rgba != nullptr);
    const auto pixels = static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height);
    unsigned sum = 0;
    for (std::size_t i = 0; i < pixels * 4; ++i) sum += out.rgba[i];
    float all = 0;
    for (std::size_t i = 0; out.samples != nullptr && i < pixels * 4; ++i) all += out.samples[i];
    require(sum < ~0U || all != all + 1);
  } else {
    require(out.rgba == nullptr && out.samples == nullptr && out.error[0] != '\0');
    require(std::strlen(out.error) < sizeof out.error);
  }
  rocinante_picture_free(out.rgba);
  rocinante_picture_free(out.samples);
  return 0;
}
