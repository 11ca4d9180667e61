#include "viewer/overlay/overlay_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

constexpr int kPanelMarginPx = 8, kPanelPaddingPx = 8, kColumnGapPx = 18;
constexpr std::uint32_t kPanelPlate = 0x14181CC8, kPanelInk = 0xE8ECF0FF,
                        kPanelHeadingInk = 0xFFD27FFF;

/// Prints -0.000 as 0.000, so that pictures do not depend on the sign of zero.
std::string fixedText(double value, int decimals) {
  if (!std::isfinite(value)) return "not a number";
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string valueText(JointType type, std::size_t component, double value) {
  constexpr double kDegreesPerRadian = 180 / kPi;
  const bool turns = type == JointType::revolute || type == JointType::continuous ||
                     (type == JointType::planar && component == 2);
  if (turns) return fixedText(value * kDegreesPerRadian, 2) + "°";
  const bool slides = type == JointType::prismatic || component < 3;
  return slides ? fixedText(value, 4) + " m" : fixedText(value, 4);
}

void addJoints(const PosedDevice& device, const SessionState& state, std::vector<PanelRow>& rows) {
  const auto found = state.devices().find(device.name);
  const JointVector joints =
      jointsOf(*device.model, found == state.devices().end() ? nullptr : &found->second);
  for (const std::size_t joint : device.model->movableJoints()) {
    const Joint& one = device.model->joints[joint];
    std::string text;
    for (std::size_t i = 0; i < valueCount(one.type); ++i) {
      const double value = joints.values[joints.first_value[joint] + i];
      text += (i > 0 ? "  " : "") + valueText(one.type, i, value);
    }
    rows.push_back({"  " + one.name, text});
  }
}

void blendPlate(Picture& picture, int left, int top, int right, int bottom) {
  constexpr std::uint32_t cover = kPanelPlate & 255U;
  for (int y = std::max(top, 0); y < std::min(bottom, picture.height); ++y) {
    for (int x = std::max(left, 0); x < std::min(right, picture.width); ++x) {
      const auto at = (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                       static_cast<std::size_t>(x)) *
                      4;
      for (unsigned c = 0; c < 3; ++c) {
        const std::uint32_t color = kPanelPlate >> (24 - 8 * c) & 255U;
        std::uint8_t& pixel = picture.rgba[at + c];
        pixel = static_cast<std::uint8_t>((color * cover + pixel * (255 - cover) + 127) / 255);
      }
    }
  }
}

}  // namespace

std::vector<PanelRow> panelRows(const std::string& time, const PosedScene& scene,
                                const SessionState& state,
                                const std::map<std::string, std::uint64_t>& rates) {
  std::vector<PanelRow> rows;
  rows.push_back({time.empty() ? "at rest" : time, {}, true});
  for (const PosedDevice& device : scene.devices) {
    if (!device.visible || device.model == nullptr) continue;
    const bool moves = !device.model->movableJoints().empty();
    if (!moves && !state.devices().contains(device.name)) continue;
    rows.push_back({device.name, device.ghost ? "ghost" : "", false});
    addJoints(device, state, rows);
  }
  if (!rates.empty()) rows.push_back({"datagrams/s", {}, true});
  for (const auto& [source, count] : rates) rows.push_back({source, std::to_string(count)});
  return rows;
}

void drawPanel(Picture& picture, const std::vector<PanelRow>& rows, const TextAtlas& atlas,
               double scale) {
  const auto scaled = [&](int px) { return static_cast<int>(px * scale + 0.5); };
  const int margin = scaled(kPanelMarginPx), padding = scaled(kPanelPaddingPx);
  const int line = atlas.linePixels();
  const int room = (picture.height - 2 * (margin + padding)) / line;
  if (room < 1) return;
  std::vector<PanelRow> shown = rows;
  if (shown.size() > static_cast<std::size_t>(room)) {
    const std::size_t kept = static_cast<std::size_t>(room) - 1;
    shown.resize(kept);
    shown.push_back({fmt::format("... and {} more", rows.size() - kept), {}, false});
  }
  int names = 0, values = 0;
  for (const PanelRow& row : shown) {
    const int value = row.value.empty() ? 0 : atlas.measure(row.value).width + scaled(kColumnGapPx);
    names = std::max(names, atlas.measure(row.name).width);
    values = std::max(values, value);
  }
  const int left = margin + padding, right = left + names + values;
  int y = margin + padding;
  blendPlate(picture, margin, margin, right + padding,
             y + static_cast<int>(shown.size()) * line + padding);
  for (const PanelRow& row : shown) {
    atlas.drawOn(picture, left, y, row.name, row.heading ? kPanelHeadingInk : kPanelInk);
    if (!row.value.empty()) {
      atlas.drawOn(picture, right - atlas.measure(row.value).width, y, row.value, kPanelInk);
    }
    y += line;
  }
}

}  // namespace rocinante
