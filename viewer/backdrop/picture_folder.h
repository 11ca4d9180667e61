#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// Pictures with times.
struct PictureFolder {
  std::vector<std::filesystem::path> files;
  std::vector<Nanoseconds> times;  ///< of each, since the session's origin; ascending
};

/// Whether `a` comes before `b`, with runs of digits compared as numbers: f9.png before f10.png.
bool comesBefore(std::string_view a, std::string_view b);

/// The files of a folder but for times.txt and hidden ones, in the order of their numbers. Their
/// times are the lines of times.txt, as `render --at-file` takes them; or every `period`, which is
/// zero when none was given. bad_argument with a sentence when there are neither, or not as many.
Result<PictureFolder> readPictureFolder(const std::filesystem::path& folder, Nanoseconds period,
                                        LogTime origin, LogTime end);

}  // namespace rocinante
