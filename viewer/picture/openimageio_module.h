#pragma once

#include <stddef.h>
#include <stdint.h>

// The C interface of librocinante_openimageio.so: the module is loaded with dlopen and shares no
// C++ with the program. Functions are found by the names of their typedefs' comments.

#define ROCINANTE_PICTURE_ABI 5

extern "C" {

/// rocinante_picture_abi: ROCINANTE_PICTURE_ABI of the module's build; others are not used.
typedef int (*RocinantePictureAbi)(void);

struct RocinantePictureOut {
  int32_t width, height;
  uint8_t* rgba;        ///< straight alpha, rows top to bottom; free with rocinante_picture_free
  int32_t components;   ///< in the file, alpha among them
  int32_t has_alpha;    ///< 1 when one of them is alpha
  int32_t bits;         ///< of each in the file
  int32_t floating;     ///< 1 when they are floating point numbers
  int32_t pictures;     ///< 1, or 2 for more; only counted with samples
  int32_t orientation;  ///< of EXIF or TIFF: 1 as stored, to 8
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
/// rocinante_picture_free: of `rgba`, `samples` or `bytes`; null is allowed.
typedef void (*RocinantePictureFree)(void* memory);

/// What is encoded: rows top to bottom, without padding; borrowed.
struct RocinantePictureIn {
  int32_t width, height;
  /// 0: RGBA of 8 bits, straight alpha, display values; 1: one float; 2: one uint32.
  int32_t kind;
  const void* pixels;
  const char* channel;      ///< of kinds 1 and 2: its name
  const char* const* text;  ///< names and values by turns, kept in the file where it can hold them
  int32_t text_count;       ///< of both together
};

struct RocinantePictureEncoded {
  void* bytes;  ///< free with rocinante_picture_free
  size_t size;
  int32_t answer;   ///< 0 encoded; 1 no format of that ending is written; 2 failed
  char error[256];  ///< one sentence, when not encoded
};

/// rocinante_picture_write: encodes in the format that the ending of `name` means. Without pixels
/// (null) only says whether it could. Any thread.
typedef void (*RocinantePictureWrite)(const char* name, const struct RocinantePictureIn* in,
                                      struct RocinantePictureEncoded* out);

}  // extern "C"
