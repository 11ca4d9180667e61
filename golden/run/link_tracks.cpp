#include "golden/run/link_tracks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/kinematics/kinematics.h"
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

/// One device while its rows are widened.
struct Chain {
  const CarriedTrack* device = nullptr;
  std::vector<std::size_t> tips;
  std::size_t own_width = 0;
  std::vector<double> rows;
  // Of the sample before: what does not change is not computed again.
  std::vector<double> known_row;
  std::vector<Mat4> links;  ///< in the device's space
  Mat4 base{1.0};
  std::size_t placed = std::numeric_limits<std::size_t>::max();  ///< the sample of `base`
  bool is_there = false;
  bool in_progress = false;
};

class LinkPlacer {
 public:
  LinkPlacer(std::vector<CarriedTrack>& devices, const std::vector<Path>& names) : names_(names) {
    for (const CarriedTrack& device : devices) {
      Chain& chain = chains_.emplace_back();
      chain.device = &device;
      chain.tips = tipLinks(*device.model);
      chain.own_width = device.track->width;
    }
  }

  void place(std::size_t samples) {
    for (Chain& chain : chains_)
      chain.rows.reserve(samples * (chain.own_width + 7 * chain.tips.size()));
    for (std::size_t sample = 0; sample < samples; ++sample) {
      for (Chain& chain : chains_) {
        placeOne(chain, sample);
        addRow(chain, sample);
      }
    }
    for (Chain& chain : chains_) {
      DeviceTrack& track = *chain.device->track;
      for (const std::size_t tip : chain.tips) {
        track.columns.push_back(
            {chain.device->model->links[tip].name, TrackColumn::Kind::link_pose, track.width});
        track.width += 7;
      }
      track.rows = std::move(chain.rows);
    }
  }

 private:
  const double* ownRow(const Chain& chain, std::size_t sample) const {
    return chain.device->track->rows.data() + sample * chain.own_width;
  }

  void placeOne(Chain& chain, std::size_t sample) {
    if (chain.placed == sample || chain.in_progress) return;
    const double* row = ownRow(chain, sample);
    const double* pose = row + chain.own_width - 7;
    chain.is_there = !std::isnan(pose[0]);
    chain.placed = sample;
    if (!chain.is_there) return;
    if (chain.known_row.size() != chain.own_width ||
        std::memcmp(chain.known_row.data(), row, chain.own_width * sizeof(double)) != 0) {
      chain.known_row.assign(row, row + chain.own_width);
      chain.links = linksOf(chain, row);
    }
    Mat4 carrier{1.0};
    const Path& on = names_[(*chain.device->carriers)[sample]];
    if (!on.first.empty()) {
      chain.in_progress = true;
      carrier = carrierOf(on, sample);
      chain.in_progress = false;
    }
    chain.base =
        carrier * matrixOf({{pose[0], pose[1], pose[2]}, {pose[6], pose[3], pose[4], pose[5]}});
  }

  Mat4 carrierOf(const Path& on, std::size_t sample) {
    for (Chain& chain : chains_) {
      if (chain.device->name != on.first || chain.in_progress) continue;
      placeOne(chain, sample);
      if (!chain.is_there) return Mat4{1.0};
      const auto link = on.second.empty() ? std::optional(chain.device->model->root)
                                          : chain.device->model->findLink(on.second);
      return link ? chain.base * chain.links[*link] : chain.base;
    }
    return Mat4{1.0};
  }

  static std::vector<Mat4> linksOf(const Chain& chain, const double* row) {
    JointVector joints = zeroJoints(*chain.device->model);
    // Columns have the values' order.
    for (std::size_t i = 0; i + 7 < chain.own_width && i < joints.values.size(); ++i) {
      if (!std::isnan(row[i])) joints.values[i] = row[i];
    }
    return linkPoses(*chain.device->model, joints);
  }

  static void addRow(Chain& chain, std::size_t sample) {
    const double* row = chain.device->track->rows.data() + sample * chain.own_width;
    chain.rows.insert(chain.rows.end(), row, row + chain.own_width);
    for (const std::size_t tip : chain.tips) {
      if (!chain.is_there || std::isnan(row[0])) {
        chain.rows.insert(chain.rows.end(), 7, std::numeric_limits<double>::quiet_NaN());
        continue;
      }
      const Pose pose = poseOf(chain.base * chain.links[tip]);
      const Quat& turn = pose.orientation;
      for (const double number :
           {pose.position.x, pose.position.y, pose.position.z, turn.x, turn.y, turn.z, turn.w}) {
        chain.rows.push_back(number);
      }
    }
  }

  const std::vector<Path>& names_;
  std::vector<Chain> chains_;
};

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

void addLinkTracks(std::vector<CarriedTrack>& devices, const std::vector<Path>& carrier_names,
                   std::size_t samples) {
  LinkPlacer(devices, carrier_names).place(samples);
}

}  // namespace rocinante
