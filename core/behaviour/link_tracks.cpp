#include "core/behaviour/link_tracks.h"

#include <algorithm>
#include <utility>

#include "core/math/transform.h"

namespace rocinante {
namespace {

bool isMoved(const Model& model, std::size_t link) {
  for (auto joint = model.links[link].parent_joint; joint;
       joint = model.links[model.joints[*joint].parent].parent_joint) {
    if (model.joints[*joint].type != JointType::fixed) return true;
  }
  return false;
}

}  // namespace

std::vector<std::size_t> tipLinks(const Model& model) {
  std::vector<bool> is_parent(model.links.size());
  for (const Joint& joint : model.joints) is_parent[joint.parent] = true;
  std::vector<std::size_t> tips;
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    if (!is_parent[link] && isMoved(model, link)) tips.push_back(link);
  }
  return tips;
}

std::vector<std::string> linksToJudge(const RunSpec& spec, const Cell& cell) {
  std::vector<std::string> links;
  for (const CellDevice& device : cell.devices) {
    const Model* model = cell.modelOf(device);
    if (model == nullptr) continue;
    const auto itemOfLink = [&](std::size_t link) {
      return device.name + "/" + model->links[link].name;
    };
    const RunLimits limits = spec.limitsOf(device.name);
    if (limits.link_positions || limits.link_turns) {
      for (const std::size_t tip : tipLinks(*model)) links.push_back(itemOfLink(tip));
    }
    for (std::size_t link = 0; link < model->links.size(); ++link) {
      const auto own = spec.own_limits.find(itemOfLink(link));
      if (own == spec.own_limits.end() || !isMoved(*model, link)) continue;
      if (own->second.position_mm || own->second.turn_deg) links.push_back(own->first);
    }
  }
  std::ranges::sort(links);
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

std::optional<LinkPlacer> LinkPlacer::of(std::string_view device, const Model& model,
                                         const std::vector<std::string>& links) {
  std::vector<std::size_t> its;
  for (const std::string& link : links) {
    if (!link.starts_with(device) || link.size() <= device.size() || link[device.size()] != '/') {
      continue;
    }
    if (const auto found = model.findLink(std::string_view(link).substr(device.size() + 1))) {
      its.push_back(*found);
    }
  }
  if (its.empty()) return std::nullopt;
  return LinkPlacer(model, std::move(its));
}

LinkPlacer::LinkPlacer(const Model& model, std::vector<std::size_t> links)
    : model_(&model), links_(std::move(links)), joints_(zeroJoints(model)) {}

void LinkPlacer::addColumns(DeviceTrack& track, std::size_t series) const {
  for (const std::size_t link : links_) {
    track.columns.push_back({model_->links[link].name, TrackColumn::Kind::link_pose, series,
                             track.series[series].width});
    track.series[series].width += 7;
  }
}

void LinkPlacer::place(const double* joints, double* out) {
  std::copy_n(joints, joints_.values.size(), joints_.values.begin());
  const std::vector<Mat4> poses = linkPoses(*model_, joints_);
  for (const std::size_t link : links_) {
    const Pose pose = poseOf(poses[link]);
    const Quat& turn = pose.orientation;
    for (const double number :
         {pose.position.x, pose.position.y, pose.position.z, turn.x, turn.y, turn.z, turn.w}) {
      *out++ = number;
    }
  }
}

}  // namespace rocinante
