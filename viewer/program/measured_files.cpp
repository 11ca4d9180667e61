#include "viewer/program/measured_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/report/json_text.h"

namespace rocinante {
namespace {

constexpr double kMaxUnits = 65535;

Json headOf(const std::filesystem::path& path, int width, int height, const MeasuredFrame& of) {
  Json json;
  json["format"] = 1;
  json["picture"] = path.filename().string();
  json["width"] = width;
  json["height"] = height;
  json["time"] = of.time;
  json["log_time_ns"] = of.log_time_ns;
  if (!of.camera.empty()) json["camera"] = of.camera;
  return json;
}

Status writeBoth(const std::filesystem::path& path, const Bytes& png, const Json& json,
                 bool overwrite, Sync sync) {
  if (png.empty()) return Error{ErrorKind::refused, "not enough memory to encode", path.string()};
  if (Status written = writeFileWhole(path, png, overwrite, sync); !written) return written;
  const std::string text = jsonText(json);
  return writeFileWhole(legendPath(path), bytesOf(text), overwrite, sync);
}

}  // namespace

std::filesystem::path legendPath(const std::filesystem::path& picture) {
  std::filesystem::path legend = picture;
  return legend.replace_extension(".json");
}

Status writeIdentity(const std::filesystem::path& path, const IdentityFrame& frame,
                     const MeasuredFrame& of, bool overwrite, Sync sync) {
  Json json = headOf(path, frame.width, frame.height, of);
  const auto colors = identityColors(frame.names);
  const auto extents = extentsOf(frame);
  json["names"] = Json::array();
  for (std::size_t i = 0; i < frame.names.size(); ++i) {
    const IdentityExtent& extent = extents[i];
    Json one;
    one["id"] = i + 1;
    one["color"] = fmt::format("#{:06x}", colors[i] >> 8U);
    one["device"] = frame.names[i].device;
    one["link"] = frame.names[i].link;
    one["pixels"] = extent.pixels;
    one["box"] = {extent.left, extent.top, extent.right, extent.bottom};
    json["names"].push_back(std::move(one));
  }
  return writeBoth(path, encodePng(identityPicture(frame)), json, overwrite, sync);
}

DepthUnits depthUnits(const DepthFrame& frame) {
  double farthest = 0;
  for (const float metres : frame.metres) {
    if (std::isfinite(metres)) farthest = std::max(farthest, static_cast<double>(metres));
  }
  DepthUnits depth;
  // Units per metre, as whole numbers: a tenth is not exact in binary.
  double per_metre = 1000;
  while (farthest * per_metre > kMaxUnits && per_metre > 1e-12) per_metre /= 10;
  depth.metres_per_unit = 1 / per_metre;
  depth.units.reserve(frame.metres.size());
  for (const float metres : frame.metres) {
    const double units = std::floor(static_cast<double>(metres) * per_metre + 0.5);
    depth.units.push_back(std::isfinite(metres)
                              ? static_cast<std::uint16_t>(std::clamp(units, 1.0, kMaxUnits))
                              : std::uint16_t{0});
  }
  return depth;
}

Status writeDepth(const std::filesystem::path& path, const DepthFrame& frame,
                  const MeasuredFrame& of, bool overwrite, Sync sync) {
  const DepthUnits depth = depthUnits(frame);
  Json json = headOf(path, frame.width, frame.height, of);
  json["metres_per_unit"] = depth.metres_per_unit;
  json["nothing"] = 0;
  std::size_t pixels = 0;
  float nearest = 0, farthest = 0;
  for (const float metres : frame.metres) {
    if (!std::isfinite(metres)) continue;
    nearest = pixels == 0 ? metres : std::min(nearest, metres);
    farthest = pixels == 0 ? metres : std::max(farthest, metres);
    ++pixels;
  }
  json["pixels"] = pixels;
  if (pixels > 0) {
    json["nearest_m"] = nearest;
    json["farthest_m"] = farthest;
  }
  return writeBoth(path, encodeGreyPng(frame.width, frame.height, depth.units), json, overwrite,
                   sync);
}

}  // namespace rocinante
