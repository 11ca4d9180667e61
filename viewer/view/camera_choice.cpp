#include "viewer/view/camera_choice.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/name_hint.h"

namespace rocinante {
namespace {

std::optional<double> numberIn(std::string_view text) {
  double value = 0;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = fault == std::errc{} && stop == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Removes and returns the text before the next `separator`; also removes the separator.
std::string_view takeUntil(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string_view taken = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  return taken;
}

std::optional<Vec3> vectorIn(std::string_view text) {
  Vec3 vector{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = numberIn(axis < 2 ? takeUntil(text, ',') : text);
    if (!value) return std::nullopt;
    vector[axis] = *value;
  }
  return vector;
}

/// Applies "fov=45" and similar parts.
bool setPart(std::string_view part, CameraView& view) {
  const std::string_view key = takeUntil(part, '=');
  if (key == "up") {
    const auto up = vectorIn(part);
    if (up) view.up = *up;
    return up.has_value();
  }
  const auto value = numberIn(part);
  if (!value) return false;
  if (key == "fov" && *value >= 0.1 && *value <= 170) {
    view.fov_deg = *value;
    return true;
  }
  if (key == "ortho" && *value > 0) {
    view.ortho_height_m = *value;
    return true;
  }
  return false;
}

std::string numbersOf(const Vec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

}  // namespace

bool hasCamera(const std::string& name, const Cell& cell, const PosedScene& scene) {
  if (name == "map" || name == "fit" || chooseCamera(name, scene).ok()) return true;
  constexpr std::string_view kOfDevice = "fit:";
  if (!name.starts_with(kOfDevice)) return false;
  const std::string device = name.substr(kOfDevice.size());
  return cell.findDevice(device) != nullptr || scene.findDevice(device) != nullptr;
}

Result<CameraView> parseViewpoint(std::string_view text) {
  const Error bad{ErrorKind::bad_argument,
                  "`" + std::string(text) +
                      "` is not a viewpoint: use @EX,EY,EZ/TX,TY,TZ, then /fov=DEG, "
                      "/ortho=HEIGHT or /up=X,Y,Z",
                  {}};
  if (!text.starts_with('@')) return bad;
  std::string_view left = text.substr(1);
  const auto eye = vectorIn(takeUntil(left, '/'));
  const auto target = vectorIn(takeUntil(left, '/'));
  if (!eye || !target) return bad;
  CameraView view;
  view.eye = *eye;
  view.target = *target;
  while (!left.empty()) {
    if (!setPart(takeUntil(left, '/'), view)) return bad;
  }
  return view;
}

std::string viewpointText(const CameraView& view) {
  std::string text = "@" + numbersOf(view.eye) + "/" + numbersOf(view.target);
  if (view.ortho_height_m) {
    text += fmt::format("/ortho={}", *view.ortho_height_m);
  } else {
    text += fmt::format("/fov={}", view.fov_deg);
  }
  if (view.up != Vec3(0, 0, 1)) text += "/up=" + numbersOf(view.up);
  return text;
}

CameraView viewOf(const PosedCamera& camera) {
  return {camera.eye,     camera.target,         camera.up,
          camera.fov_deg, camera.ortho_height_m, camera.intrinsics};
}

Result<CameraView> chooseCamera(const std::string& name, const PosedScene& scene) {
  if (const PosedCamera* camera = scene.findCamera(name)) return viewOf(*camera);
  if (name.starts_with('@')) return parseViewpoint(name);
  std::vector<std::string_view> names;
  for (const PosedCamera& camera : scene.cameras) names.emplace_back(camera.name);
  return Error{
      ErrorKind::not_found, "unknown camera `" + name + "`: " + whatThereIs(name, names), {}};
}

}  // namespace rocinante
