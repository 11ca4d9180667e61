#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/name_hint.h"
#include "core/cell/cell_sections.h"
#include "core/document/fault_list.h"
#include "core/mesh/mesh_builder.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxInsets = 16;
constexpr double kLeastInsetPx = 16, kMaxInsetPx = 16384;

std::optional<InsetCorner> cornerNamed(std::string_view name) {
  if (name == "top-right") return InsetCorner::top_right;
  if (name == "top-left") return InsetCorner::top_left;
  if (name == "bottom-right") return InsetCorner::bottom_right;
  if (name == "bottom-left") return InsetCorner::bottom_left;
  return std::nullopt;
}

void readInsetSize(TomlTable& table, CellInset& inset) {
  const auto parts = table.pair("size");
  const auto pixels = table.pair("size_px");
  if (table.has("size") && table.has("size_px")) {
    table.error("cell.useless-unit", "size_px", "the inset has both size and size_px");
    return;
  }
  const auto within = [](const Vec2& pair, double least, double most) {
    return pair.x >= least && pair.x <= most && pair.y >= least && pair.y <= most;
  };
  if (parts && !within(*parts, 0.01, 1)) {
    table.error("cell.bad-number", "size", "`size` is width and height, each from 0.01 to 1",
                "in pixels it is `size_px`");
  } else if (parts) {
    inset.width = parts->x;
    inset.height = parts->y;
  }
  if (!pixels) return;
  if (!within(*pixels, kLeastInsetPx, kMaxInsetPx) || std::floor(pixels->x) != pixels->x ||
      std::floor(pixels->y) != pixels->y) {
    table.error("cell.bad-number", "size_px",
                "`size_px` is width and height in whole pixels, each from 16 to 16384");
    return;
  }
  inset.width = pixels->x;
  inset.height = pixels->y;
  inset.in_pixels = true;
}

void readPixels(TomlTable& table, std::string_view key, int most, int& value) {
  const auto given = table.number(key);
  if (!given) return;
  if (*given >= 0 && *given <= most && std::floor(*given) == *given) {
    value = static_cast<int>(*given);
  } else {
    table.error("cell.bad-number", key,
                fmt::format("`{}` must be a whole number from 0 to {}", key, most));
  }
}

void checkCamera(const TomlTable& table, const Cell& cell, const std::string& camera) {
  constexpr std::string_view kFit = "fit:";
  if (camera == "map" || camera == "fit" || cell.findCamera(camera) != nullptr) return;
  const bool of_device = camera.starts_with(kFit);
  if (of_device && cell.findDevice(camera.substr(kFit.size())) != nullptr) return;
  std::vector<std::string> of_devices;
  for (const CellDevice& device : cell.devices) of_devices.push_back("fit:" + device.name);
  std::vector<std::string_view> names{"map", "fit"};
  for (const CellCamera& one : cell.cameras) names.push_back(one.name);
  if (of_device) names.insert(names.end(), of_devices.begin(), of_devices.end());
  std::string hint = didYouMean(camera, names);
  if (hint.empty()) hint = "a `view` that a source sends outranks a [[camera]] of its name";
  table.faults().warning("cell.unknown-camera", table.place("camera"),
                         (of_device ? "no [[device]] has the camera " : "no [[camera]] is named ") +
                             quotedInFault(camera),
                         std::move(hint));
}

}  // namespace

void readInsets(TomlTable& root, Cell& cell) {
  for (TomlTable& table : root.tables("inset", "[[inset]]")) {
    CellInset inset;
    const auto camera = table.requiredName("camera");
    if (const auto corner = table.text("corner")) {
      const auto named = cornerNamed(*corner);
      if (named) inset.corner = *named;
      if (!named) {
        table.error("cell.unknown-word", "corner",
                    fmt::format("{} is not a corner", quotedInFault(*corner)),
                    "top-right, top-left, bottom-right or bottom-left");
      }
    }
    readInsetSize(table, inset);
    readPixels(table, "margin_px", 1000, inset.margin_px);
    readPixels(table, "border_px", 100, inset.border_px);
    if (const auto color = table.color("border")) inset.border_rgba = packedColor(*color);
    inset.title = table.text("title");
    table.finish();
    if (!camera) continue;
    checkCamera(table, cell, *camera);
    inset.camera = *camera;
    if (cell.insets.size() == kMaxInsets) {
      table.error("cell.too-many", "camera",
                  fmt::format("the cell has more than {} insets", kMaxInsets));
      return;
    }
    cell.insets.push_back(std::move(inset));
  }
}

}  // namespace rocinante
