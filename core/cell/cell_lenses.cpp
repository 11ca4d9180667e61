#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/cell/cell_sections.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

/// Pixels; none a focal length or a middle may reach.
constexpr double kFarthest = 1e6;

std::optional<double> pixels(TomlTable& table, std::string_view key, double least) {
  const auto value = table.number(key);
  if (!value) {
    if (!table.has(key)) {
      table.faults().error("cell.missing-key", table.place(),
                           fmt::format("{} lacks `{}`", table.what(), key));
    }
    return std::nullopt;
  }
  if (*value >= least && *value <= kFarthest) return value;
  table.error(
      "cell.bad-number", key,
      fmt::format("`{}` of {} must be {} to {:.0f} pixels", key, table.what(), least, kFarthest));
  return std::nullopt;
}

std::optional<int> side(TomlTable& table, std::string_view key) {
  const auto value = pixels(table, key, 1);
  if (!value) return std::nullopt;
  if (*value <= kMaxLensSide && *value == std::floor(*value)) return static_cast<int>(*value);
  table.error(
      "cell.bad-number", key,
      fmt::format("`{}` of {} must be a whole number up to {}", key, table.what(), kMaxLensSide));
  return std::nullopt;
}

std::optional<CameraIntrinsics> readIntrinsics(TomlTable lens) {
  const auto fx = pixels(lens, "fx", 1), fy = pixels(lens, "fy", 1);
  const auto cx = pixels(lens, "cx", -kFarthest), cy = pixels(lens, "cy", -kFarthest);
  const auto width = side(lens, "width"), height = side(lens, "height");
  lens.finish();
  if (!fx || !fy || !cx || !cy || !width || !height) return std::nullopt;
  if (std::int64_t{*width} * *height > kMaxLensPixels) {
    lens.error("cell.bad-number", "width", "the picture has more pixels than 7680x4320");
    return std::nullopt;
  }
  return CameraIntrinsics{*fx, *fy, *cx, *cy, *width, *height};
}

std::optional<LensDistortion> readDistortion(const TomlTable& table, const TomlNode& list) {
  std::array<double, 5> k{};
  bool sound =
      list.kind == TomlNode::Kind::array && (list.items.size() == 4 || list.items.size() == 5);
  for (std::size_t i = 0; sound && i < list.items.size(); ++i) {
    const TomlNode& item = list.items[i];
    sound = (item.kind == TomlNode::Kind::integer || item.kind == TomlNode::Kind::number) &&
            std::abs(item.number) <= kFarthest;
    k[i] = item.number;
  }
  if (sound) return LensDistortion{k[0], k[1], k[2], k[3], k[4]};
  table.error("cell.bad-number", "distortion",
              "`distortion` must be the numbers k1, k2, p1, p2 and, if there is one, k3");
  return std::nullopt;
}

}  // namespace

void readLens(TomlTable& table, CellCamera& camera) {
  if (auto lens = table.table("intrinsics", "intrinsics")) {
    camera.intrinsics = readIntrinsics(std::move(*lens));
    if (table.has("fov_deg") || table.has("ortho_height_m")) {
      table.error("cell.two-projections", "intrinsics",
                  "the camera has both intrinsics and fov_deg or ortho_height_m");
      camera.intrinsics.reset();
    }
  }
  if (const TomlNode* const list = table.node("distortion")) {
    camera.distortion = readDistortion(table, *list).value_or(LensDistortion());
    if (!table.has("intrinsics")) {
      table.error("cell.missing-key", "distortion", "`distortion` needs `intrinsics`");
    }
  }
  if (!camera.intrinsics) return;
  const CameraIntrinsics& lens = *camera.intrinsics;
  camera.fov_deg = degreesOf(2 * arcTangent(lens.height / (2 * lens.fy)));
}

}  // namespace rocinante
