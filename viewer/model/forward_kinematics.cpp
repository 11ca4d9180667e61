#include <fmt/format.h>

#include <cmath>

#include "core/base/plain_text.h"
#include "core/cli/text_table.h"
#include "viewer/model/pose_request.h"

namespace rocinante {
namespace {

std::string sixDecimals(double value) {
  return fmt::format("{:.6f}", std::abs(value) < 5e-7 ? 0.0 : value);
}

}  // namespace

Result<std::vector<LinkPose>> forwardKinematics(const Cell& cell, const PoseRequest& request,
                                                StateDamage* damage) {
  const Result<SessionState> state = posedState(cell, request, damage);
  if (!state) return state.error();
  std::vector<LinkPose> links = linkPoses(cell, *state, request.device);
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

}  // namespace rocinante
