#include <fmt/format.h>

#include "core/base/hash.h"
#include "core/packet/state_items.h"
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

Json jsonOf(const Item<PresenceValue>& item) {
  Json out = {{"is", item.value.presence == Presence::removed ? "removed" : "added"}};
  if (item.value.presence == Presence::added) {
    out["model"] = item.value.model;
    if (item.value.kinematics) out["kin"] = fmt::format("{:016x}", *item.value.kinematics);
  }
  out["owner"] = item.owner;
  return out;
}

Json jsonOf(const Item<PoseValue>& item) {
  const Quat& q = item.value.pose.orientation;
  return {{"position_m", jsonOf(item.value.pose.position)},
          {"orientation_xyzw", Json::array({q.x, q.y, q.z, q.w})},
          {"in", carrierJson(item.value.carrier)},
          {"owner", item.owner}};
}

/// A value of its kind's own type; the unit is null where none was said.
Json jsonOf(const SignalName& name, const Item<SignalValue>& item) {
  const SignalValue& stated = item.value;
  Json out = {{"name", name.name}, {"link", orNull(name.link)}};
  switch (stated.kind) {
    case SignalKind::number:
      out["value"] = stated.number;
      break;
    case SignalKind::boolean:
      out["value"] = stated.number != 0;
      break;
    case SignalKind::text:
      out["value"] = stated.text;
      break;
  }
  out["unit"] = orNull(stated.unit);
  out["owner"] = item.owner;
  return out;
}

Json jsonOf(const std::string& name, const DeviceState& device) {
  Json out = {{"name", name}, {"last_write_ns", nanosecondsOf(device.last_write)}};
  for (const char* const one : {"presence", "pose", "joints"}) out[one] = nullptr;
  for (const char* const several : {"named_joints", "orders", "signals"}) {
    out[several] = Json::array();
  }
  const ByKind add{
      [&](const PresenceItem& stated) { out["presence"] = jsonOf(stated.item); },
      [&](const PoseItem& stated) { out["pose"] = jsonOf(stated.item); },
      [&](const PositionsItem& stated) {
        out["joints"] = {{"values", stated.item.value}, {"owner", stated.owner()}};
      },
      [&](const JointItem& stated) {
        out["named_joints"].push_back(
            {{"name", stated.joint}, {"value", stated.item.value}, {"owner", stated.owner()}});
      },
      [&](const OrderItem& stated) {
        out["orders"].push_back({{"joints", stated.item.value}, {"owner", stated.owner()}});
      },
      [&](const SignalItem& stated) { out["signals"].push_back(jsonOf(stated.name, stated.item)); },
  };
  eachItemOf(name, device, add);
  return out;
}

Json jsonOf(const std::pair<std::string, std::string>& key, const Drawing& drawing) {
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

Json jsonOf(const std::string& name, const Item<ViewValue>& item) {
  return {{"name", name},
          {"eye_m", jsonOf(item.value.eye)},
          {"target_m", jsonOf(item.value.target)},
          {"up", jsonOf(item.value.up)},
          {"fov_deg", item.value.fov_deg},
          {"ortho_height_m", orNull(item.value.ortho_height_m)},
          {"in", carrierJson(item.value.carrier)},
          {"owner", item.owner}};
}

Json jsonOf(const std::string& name, const SourceState& source) {
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

Json jsonOf(const Path& path, const Item<Visibility>& item) {
  return {{"path", jsonOf(path)}, {"is", visibilityName(item.value.kind)}, {"owner", item.owner}};
}

Json jsonOf(const Path& path, const Item<ColorValue>& item) {
  const Json color = item.value.rgba ? Json(colorOf(*item.value.rgba)) : Json(nullptr);
  return {{"path", jsonOf(path)}, {"color", color}, {"owner", item.owner}};
}

template <class Map>
Json listOf(const Map& items) {
  Json out = Json::array();
  for (const auto& [key, value] : items) out.push_back(jsonOf(key, value));
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
  out["sources"] = listOf(state.sources());
  eachMap(state,
          [&](std::string_view name, const auto& map) { out[std::string(name)] = listOf(map); });
  return jsonText(out, -1);
}

}  // namespace rocinante
