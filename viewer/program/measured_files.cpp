#include "viewer/program/measured_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/report/json_text.h"
#include "viewer/picture/picture_module.h"

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

/// `json` is the legend: beside the picture, and in it where it has a place for it.
Status writeBoth(const std::filesystem::path& path, const Result<Bytes>& picture,
                 const std::string& legend, bool overwrite, Sync sync) {
  if (!picture) return Error{picture.error().kind, picture.error().what, path.string()};
  if (picture->empty()) {
    return Error{ErrorKind::refused, "not enough memory to encode", path.string()};
  }
  if (Status written = writeFileWhole(path, *picture, overwrite, sync); !written) return written;
  return writeFileWhole(legendPath(path), bytesOf(legend), overwrite, sync);
}

MeasuredPicture measuredPicture(int width, int height, const char* channel, const Json& legend) {
  MeasuredPicture picture;
  picture.width = width;
  picture.height = height;
  picture.channel = channel;
  picture.text = {"rocinante", jsonText(legend, -1)};
  return picture;
}

}  // namespace

std::filesystem::path legendPath(const std::filesystem::path& picture) {
  std::filesystem::path legend = picture;
  return legend.replace_extension(".json");
}

bool isExrName(const std::filesystem::path& path) {
  return path.extension() == ".exr" || path.extension() == ".EXR";
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
  const std::string legend = jsonText(json);
  if (!isExrName(path)) {
    return writeBoth(path, encodePng(identityPicture(frame)), legend, overwrite, sync);
  }
  MeasuredPicture picture = measuredPicture(frame.width, frame.height, "id", json);
  picture.numbers = frame.ids;
  return writeBoth(path, encodeByModule(path.string(), picture), legend, overwrite, sync);
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
  const bool is_exr = isExrName(path);
  const DepthUnits depth = is_exr ? DepthUnits{1, {}} : depthUnits(frame);
  Json json = headOf(path, frame.width, frame.height, of);
  json["metres_per_unit"] = depth.metres_per_unit;
  if (is_exr) {
    json["nothing"] = "infinity";
  } else {
    json["nothing"] = 0;
  }
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
  const std::string legend = jsonText(json);
  if (!is_exr) {
    return writeBoth(path, encodeGreyPng(frame.width, frame.height, depth.units), legend, overwrite,
                     sync);
  }
  MeasuredPicture picture = measuredPicture(frame.width, frame.height, "Z", json);
  picture.floats = frame.metres;
  return writeBoth(path, encodeByModule(path.string(), picture), legend, overwrite, sync);
}

}  // namespace rocinante
