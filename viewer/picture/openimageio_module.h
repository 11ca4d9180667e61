#pragma once

#include <stddef.h>
#include <stdint.h>

// The C interface of librocinante_openimageio.so: the module is loaded with dlopen and shares no
// C++ with the program. Functions are found by the names of their typedefs' comments.

#define ROCINANTE_PICTURE_ABI 3

extern "C" {

/// rocinante_picture_abi: ROCINANTE_PICTURE_ABI of the module's build; others are not used.
typedef int (*RocinantePictureAbi)(void);

struct RocinantePictureOut {
  int32_t width, height;
  uint8_t* rgba;       ///< straight alpha, rows top to bottom; free with rocinante_picture_free
  int32_t components;  ///< in the file, alpha among them
  int32_t has_alpha;   ///< 1 when one of them is alpha
  int32_t bits;        ///< of each in the file
  int32_t floating;    ///< 1 when they are floating point numbers
  int32_t pictures;    ///< 1, or 2 for more; only counted with samples
  /// When samples were requested and the file has more than 8 bits: RGBA of each pixel with the
  /// file's values, premultiplied if the file is; freed like `rgba`.
  float* samples;
  /// 0 read; 1 cannot be opened as a picture; 2 too many pixels; 3 damaged.
  int32_t answer;
  char error[256];  ///< one sentence, when not read
};

/// rocinante_picture_read: decodes the first picture in the file `name` or, if not null, in
/// `bytes`; `name` then only selects the format by its extension. Any thread.
typedef void (*RocinantePictureRead)(const char* name, const void* bytes, size_t size,
                                     int64_t max_pixels, int32_t with_samples,
                                     struct RocinantePictureOut* out);
/// rocinante_picture_free: of `rgba` or `samples`; null is allowed.
typedef void (*RocinantePictureFree)(void* memory);

}  // extern "C"
