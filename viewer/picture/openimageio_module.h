#pragma once

#include <stddef.h>
#include <stdint.h>

// What librocinante_openimageio.so offers, in C: the module is loaded with dlopen and shares no
// C++ with the program. Functions are found by the names of their typedefs' comments.

#define ROCINANTE_PICTURE_ABI 2

extern "C" {

/// rocinante_picture_abi: ROCINANTE_PICTURE_ABI of the module's build; others are not used.
typedef int (*RocinantePictureAbi)(void);

struct RocinantePictureOut {
  int32_t width, height;
  uint8_t* rgba;  ///< straight alpha, rows top to bottom; given back to rocinante_picture_free
  /// 0 read; 1 cannot be opened as a picture; 2 too many pixels; 3 damaged.
  int32_t answer;
  char error[256];  ///< one sentence, when it was not read
};

/// rocinante_picture_read: decodes the first picture in the file `name`, or, when `bytes` is not
/// null, in those, which `name` then only gives the format by its ending. Any thread.
typedef void (*RocinantePictureRead)(const char* name, const void* bytes, size_t size,
                                     int64_t max_pixels, struct RocinantePictureOut* out);
/// rocinante_picture_free
typedef void (*RocinantePictureFree)(uint8_t* rgba);

}  // extern "C"
