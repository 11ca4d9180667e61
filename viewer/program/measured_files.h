#pragma once

#include <filesystem>
#include <string>

#include "core/base/atomic_file.h"
#include "viewer/render/identity_frame.h"

namespace rocinante {

/// The frame of a file, for its JSON.
struct MeasuredFrame {
  std::string time;  ///< as requested; "rest" without a log
  std::int64_t log_time_ns = 0;
  std::string camera;  ///< empty: the default
};

/// Whether the name's ending is .exr or .EXR.
bool isExrName(const std::filesystem::path& path);

/// Writes `path`, the ids as a PNG in identityColors() on black, or as whole numbers in an OpenEXR
/// file, which has the legend as its attribute `rocinante` too; and the legend beside it with the
/// extension .json: docs/programs/render.md, "Identity". Both appear whole or not at all, and are
/// replaced only with `overwrite`. Any thread.
Status writeIdentity(const std::filesystem::path& path, const IdentityFrame& frame,
                     const MeasuredFrame& of, bool overwrite, Sync sync);

/// The same for depth: a PNG of one 16-bit component, its unit in the JSON; or an OpenEXR file of
/// metres.
Status writeDepth(const std::filesystem::path& path, const DepthFrame& frame,
                  const MeasuredFrame& of, bool overwrite, Sync sync);

/// The path of a file's JSON.
std::filesystem::path legendPath(const std::filesystem::path& picture);

/// Depth in units from 1; 0 for nothing or NaN.
struct DepthUnits {
  double metres_per_unit = 0.001;
  std::vector<std::uint16_t> units;
};

/// The unit is 1 mm times the smallest power of ten that can represent the farthest pixel.
DepthUnits depthUnits(const DepthFrame& frame);

}  // namespace rocinante
