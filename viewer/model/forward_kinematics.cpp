#include "viewer/model/forward_kinematics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/plain_text.h"
#include "core/cli/text_table.h"
#include "core/math/transform.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

// Removes the sign of zero.
double plainZero(double value) { return value == 0.0 ? 0.0 : value; }

std::string sixDecimals(double value) {
  return fmt::format("{:.6f}", plainZero(std::abs(value) < 5e-7 ? 0.0 : value));
}

}  // namespace

Result<std::vector<LinkPose>> forwardKinematics(const Cell& cell, const PoseRequest& request,
                                                StateDamage* damage) {
  const Result<SessionState> state = posedState(cell, request, damage);
  if (!state) return state.error();
  const PosedScene scene = poseScene(cell, *state);
  const bool one = !request.device.empty() || cell.devices.size() == 1;
  std::vector<LinkPose> links;
  for (const PosedDevice& device : scene.devices) {
    if (!request.device.empty() && device.name != request.device) continue;
    for (std::size_t i = 0; i < device.model->links.size(); ++i) {
      const std::string& link = device.model->links[i].name;
      links.push_back({one ? link : device.name + "/" + link, poseOf(device.link_world[i])});
    }
  }
  if (links.empty()) {
    return Error{ErrorKind::bad_argument, "the cell has no device at that moment",
                 cell.shown(cell.file)};
  }
  return links;
}

std::string forwardKinematicsText(const std::vector<LinkPose>& links) {
  cli::TextTable table;
  table.is_number = {false, true, true, true, true, true, true, true};
  table.rows.push_back({"link", "x", "y", "z", "qx", "qy", "qz", "qw"});
  for (const LinkPose& link : links) {
    const Vec3& at = link.pose.position;
    const Quat& turn = link.pose.orientation;
    std::vector<std::string> row{plainText(link.link)};
    for (const double value : {at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w}) {
      row.push_back(sixDecimals(value));
    }
    table.rows.push_back(std::move(row));
  }
  return table.text();
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
