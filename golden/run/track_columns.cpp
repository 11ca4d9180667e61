#include "golden/run/track_columns.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "core/kinematics/joint_values.h"

namespace rocinante {
namespace {

TrackColumn::Kind columnKind(const Joint& joint, std::size_t component) {
  if (kindOf(joint, component) != ValueKind::angle) return TrackColumn::Kind::length;
  return joint.type == JointType::revolute ? TrackColumn::Kind::angle
                                           : TrackColumn::Kind::full_angle;
}

}  // namespace

std::vector<TrackColumn> columnsOf(const Model& model) {
  std::vector<TrackColumn> columns;
  std::size_t offset = 0;
  const auto add = [&](TrackColumn column) {
    column.offset = offset;
    offset += column.width();
    columns.push_back(std::move(column));
  };
  for (const Joint& joint : model.joints) {
    if (joint.type == JointType::floating) {
      add({joint.name, TrackColumn::Kind::pose});
      continue;
    }
    for (std::size_t i = 0; i < valueCount(joint.type); ++i) {
      add({valueName(joint, i), columnKind(joint, i)});
    }
  }
  add({"", TrackColumn::Kind::pose});
  return columns;
}

void interpolate(const TrackColumn& column, const double* a, const double* b, double part,
                 double* out) {
  if (column.kind == TrackColumn::Kind::full_angle) {
    out[0] = a[0] + part * std::remainder(b[0] - a[0], 2 * std::numbers::pi);
    return;
  }
  const std::size_t linear = column.width() == 7 ? 3 : 1;
  for (std::size_t i = 0; i < linear; ++i) out[i] = a[i] + part * (b[i] - a[i]);
  if (linear == 1) return;
  // q and -q are the same orientation.
  double dot = 0;
  for (std::size_t i = 3; i < 7; ++i) dot += a[i] * b[i];
  const double sign = dot < 0 ? -1 : 1;
  double square = 0;
  for (std::size_t i = 3; i < 7; ++i) {
    out[i] = a[i] + part * (sign * b[i] - a[i]);
    square += out[i] * out[i];
  }
  if (!(square > 0)) return;
  for (std::size_t i = 3; i < 7; ++i) out[i] /= std::sqrt(square);
}

}  // namespace rocinante
