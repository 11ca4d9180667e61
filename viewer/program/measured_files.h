#pragma once

#include <filesystem>
#include <string>

#include "core/base/atomic_file.h"
#include "viewer/render/identity_frame.h"

namespace rocinante {

/// Which frame a file is of: for the JSON beside it.
struct MeasuredFrame {
  std::string time;  ///< as it was asked for; "rest" without a log
  std::int64_t log_time_ns = 0;
  std::string camera;  ///< empty: the default
};

/// Writes `path`, the ids as a PNG in identityColors() on black, and the legend beside it, with
/// .json in place of its ending: docs/programs/render.md, "Identity". Both appear whole or not at
/// all, and are replaced only with `overwrite`. Any thread.
Status writeIdentity(const std::filesystem::path& path, const IdentityFrame& frame,
                     const MeasuredFrame& of, bool overwrite, Sync sync);

/// The same of depth: a PNG of one 16-bit component, whose unit the JSON says.
Status writeDepth(const std::filesystem::path& path, const DepthFrame& frame,
                  const MeasuredFrame& of, bool overwrite, Sync sync);

/// Where the JSON of such a file stands.
std::filesystem::path legendPath(const std::filesystem::path& picture);

/// Metres in units from 1 on; 0 where there is nothing, or no number.
struct DepthUnits {
  double metres_per_unit = 0.001;
  std::vector<std::uint16_t> units;
};

/// The unit is 1 mm, or the smallest power of ten of it that the farthest pixel can be said in.
DepthUnits depthUnits(const DepthFrame& frame);

}  // namespace rocinante
