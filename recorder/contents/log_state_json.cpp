#include <fmt/format.h>

#include "core/base/hash.h"
#include "core/report/json_text.h"
#include "recorder/contents/log_state.h"

namespace rocinante {
namespace {

Json jsonOf(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

std::string colorOf(std::uint32_t rgba) { return fmt::format("#{:08x}", rgba); }

/// {"layer"} or {"device"[, "link"]}.
Json jsonOf(const Path& path) {
  if (path.is_layer) return {{"layer", path.second}};
  Json out = {{"device", path.first}};
  if (!path.second.empty()) out["link"] = path.second;
  return out;
}

/// Null for the world.
Json carrierJson(const Path& path) { return path.first.empty() ? Json(nullptr) : jsonOf(path); }

Json presenceJson(const Item<PresenceValue>& item) {
  Json out = {{"is", item.value.presence == Presence::removed ? "removed" : "added"}};
  if (item.value.presence == Presence::added) {
    out["model"] = item.value.model;
    if (item.value.kinematics) out["kin"] = fmt::format("{:016x}", *item.value.kinematics);
  }
  out["owner"] = item.owner;
  return out;
}

Json poseJson(const Item<PoseValue>& item) {
  const Quat& q = item.value.pose.orientation;
  return {{"position_m", jsonOf(item.value.pose.position)},
          {"orientation_xyzw", Json::array({q.x, q.y, q.z, q.w})},
          {"in", carrierJson(item.value.carrier)},
          {"owner", item.owner}};
}

Json deviceJson(const std::string& name, const DeviceState& device) {
  Json out = {{"name", name}, {"last_write_ns", nanosecondsOf(device.last_write)}};
  out["presence"] = device.presence ? presenceJson(*device.presence) : Json(nullptr);
  out["pose"] = device.pose ? poseJson(*device.pose) : Json(nullptr);
  out["joints"] = device.joints
                      ? Json({{"values", device.joints->value}, {"owner", device.joints->owner}})
                      : Json(nullptr);
  out["named_joints"] = Json::array();
  for (const auto& [joint, item] : device.named_joints) {
    out["named_joints"].push_back({{"name", joint}, {"value", item.value}, {"owner", item.owner}});
  }
  out["orders"] = Json::array();
  for (const auto& [source, joints] : device.orders) {
    out["orders"].push_back({{"joints", joints}, {"owner", source}});
  }
  return out;
}

Json drawingJson(const std::pair<std::string, std::string>& key, const Drawing& drawing) {
  Json out = {{"id", key.second},
              {"kind", nameOf(drawing.kind)},
              {"color", colorOf(drawing.rgba)},
              {"size_px", drawing.size_px},
              {"in", carrierJson(drawing.carrier)}};
  if (drawing.kind == StatementKind::label) out["text"] = drawing.text;
  out["parts"] = Json::array();
  for (const auto& part : drawing.parts) out["parts"].push_back(orNull(part));
  out["owner"] = key.first;
  return out;
}

Json viewJson(const std::string& name, const Item<ViewValue>& item) {
  return {{"name", name},
          {"eye_m", jsonOf(item.value.eye)},
          {"target_m", jsonOf(item.value.target)},
          {"up", jsonOf(item.value.up)},
          {"fov_deg", item.value.fov_deg},
          {"ortho_height_m", orNull(item.value.ortho_height_m)},
          {"in", carrierJson(item.value.carrier)},
          {"owner", item.owner}};
}

Json sourceJson(const std::string& name, const SourceState& source) {
  return {{"name", name},
          {"run", orNull(source.run)},
          {"sequence", orNull(source.highest_sequence)},
          {"time_ns", orNull(source.time_ns)}};
}

std::string_view visibilityName(Visibility::Kind kind) {
  switch (kind) {
    case Visibility::Kind::shown:
      return "shown";
    case Visibility::Kind::hidden:
      return "hidden";
    case Visibility::Kind::by_default:
      break;
  }
  return "default";
}

Json visibilityJson(const Path& path, const Item<Visibility>& item) {
  return {{"path", jsonOf(path)}, {"is", visibilityName(item.value.kind)}, {"owner", item.owner}};
}

Json colorJson(const Path& path, const Item<ColorValue>& item) {
  const Json color = item.value.rgba ? Json(colorOf(*item.value.rgba)) : Json(nullptr);
  return {{"path", jsonOf(path)}, {"color", color}, {"owner", item.owner}};
}

template <class Map, class Make>
Json listOf(const Map& items, Make make) {
  Json out = Json::array();
  for (const auto& [key, value] : items) out.push_back(make(key, value));
  return out;
}

}  // namespace

std::string identityHash(const SessionState& state) {
  Sha256 hash;
  hash.add(bytesOf(state.identityText()));
  return hexOf(hash.finish());
}

std::string stateJson(const ShownState& shown) {
  const SessionState& state = *shown.state;
  Json out = {{"format", 1},
              {"log", shown.log},
              {"at_ns", nanosecondsOf(shown.moment)},
              {"origin_ns", nanosecondsOf(shown.origin)},
              {"identity_sha256", identityHash(state)}};
  out["sources"] = listOf(state.sources(), sourceJson);
  out["devices"] = listOf(state.devices(), deviceJson);
  out["visibility"] = listOf(state.visibility(), visibilityJson);
  out["colors"] = listOf(state.colors(), colorJson);
  out["drawings"] = listOf(state.drawings(), drawingJson);
  out["views"] = listOf(state.views(), viewJson);
  return jsonText(out, -1);
}

}  // namespace rocinante
