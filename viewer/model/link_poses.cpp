#include "viewer/model/link_poses.h"

#include <algorithm>
#include <string_view>

#include "core/math/transform.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

// Removes the sign of zero.
double plainZero(double value) { return value == 0.0 ? 0.0 : value; }

}  // namespace

std::vector<LinkPose> linkPoses(const Cell& cell, const SessionState& state,
                                const std::string& device) {
  const PosedScene scene = poseScene(cell, state);
  const bool one = !device.empty() || cell.devices.size() == 1;
  std::vector<LinkPose> links;
  for (const PosedDevice& each : scene.devices) {
    if (!device.empty() && each.name != device) continue;
    for (std::size_t i = 0; i < each.model->links.size(); ++i) {
      const std::string& link = each.model->links[i].name;
      links.push_back({one ? link : each.name + "/" + link, poseOf(each.link_world[i])});
    }
  }
  return links;
}

std::string forwardKinematicsJson(const std::vector<LinkPose>& links,
                                  const std::vector<std::string>& warnings) {
  // One line per link, for readability.
  const auto dumped = [](const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  const auto isLink = [&](std::string_view name) {
    return std::ranges::any_of(links, [&](const LinkPose& link) { return link.link == name; });
  };
  std::string out = isLink("format") ? "{" : "{\n  \"format\": 1";
  if (!warnings.empty() && !isLink("warnings")) {
    out += out.size() > 1 ? ",\n  " : "\n  ";
    out += "\"warnings\": " + dumped(warnings);
  }
  for (const LinkPose& link : links) {
    const Vec3& at = link.pose.position;
    const Quat& turn = link.pose.orientation;
    const Json pose = {
        {"xyz", {plainZero(at.x), plainZero(at.y), plainZero(at.z)}},
        {"quaternion",
         {plainZero(turn.x), plainZero(turn.y), plainZero(turn.z), plainZero(turn.w)}}};
    out += out.size() > 1 ? ",\n  " : "\n  ";
    out += dumped(link.link) + ": " + dumped(pose);
  }
  return out + "\n}\n";
}

}  // namespace rocinante
