#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// What `--backdrop` and its companions say.
struct BackdropRequest {
  std::filesystem::path file;  ///< a picture, a folder of them or a video; empty: no backdrop
  std::string camera;          ///< empty: the only calibrated one
  Nanoseconds period{0};       ///< of a folder without times; 0: not given
  std::string offset;          ///< a duration: session time of its time zero; empty: 0
  double opacity = 0.5;        ///< over the scene: 0 to 1
};

/// "FILE", "FOLDER,fps=25", "VIDEO,camera=NAME". Commas that no `camera=` or `fps=` follows are the
/// file's. bad_argument.
Result<BackdropRequest> parseBackdrop(std::string_view text);
/// The text of file, period and this camera, for parseBackdrop().
std::string backdropText(const BackdropRequest& request, const std::string& camera);

}  // namespace rocinante
