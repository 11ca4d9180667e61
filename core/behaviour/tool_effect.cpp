#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/behaviour/column_samples.h"
#include "core/behaviour/link_tracks.h"
#include "core/behaviour/run_judge.h"
#include "core/behaviour/session_track.h"
#include "core/kinematics/kinematics.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

constexpr std::size_t kMostEffects = 20;
constexpr double kLeastEffect_mm = 0.1;
constexpr double kMostTurn_deg = 180;  ///< beyond, the distance says nothing

/// The joints of a device of the run, over time.
class JointsOverTime {
 public:
  JointsOverTime(const SessionTrack& run, const DeviceTrack& device, const Model& model)
      : start_(run.start), joints_(zeroJoints(model)) {
    const TimeMap its_own{{{run.start, run.start}}};
    times_ = alignedTimes(run, device.series.front(), its_own, run.start);
    for (const TrackColumn& column : device.columns) {
      if (column.part.empty() || column.kind == TrackColumn::Kind::link_pose) continue;
      columns_.emplace_back(column,
                            ColumnSamples(run, device.series[column.series], column, times_));
    }
  }

  /// Empty where some are not stated.
  std::optional<JointVector> at(LogTime time) const {
    JointVector joints = joints_;
    for (const auto& [column, samples] : columns_) {
      if (column.offset + column.width() > joints.values.size()) return std::nullopt;
      if (!samples.valueAt((time - start_).count(), joints.values.data() + column.offset)) {
        return std::nullopt;
      }
    }
    return joints;
  }

  /// Its place in the values; empty where it is not an angle of the device.
  std::optional<std::size_t> placeOf(std::string_view part) const {
    for (const auto& [column, samples] : columns_) {
      if (column.part == part && column.kind <= TrackColumn::Kind::full_angle) return column.offset;
    }
    return std::nullopt;
  }

 private:
  LogTime start_;
  JointVector joints_;
  std::vector<std::int64_t> times_;
  std::vector<std::pair<TrackColumn, ColumnSamples>> columns_;
};

/// Whether the session's device has this model: packets may have added another.
bool isOf(const Model& model, const DeviceTrack& device) {
  const std::vector<TrackColumn> columns = columnsOf(model);
  return device.columns.size() >= columns.size() &&
         std::equal(columns.begin(), columns.end(), device.columns.begin(),
                    [](const TrackColumn& a, const TrackColumn& b) {
                      return a.part == b.part && a.kind == b.kind;
                    });
}

/// " (38.0 mm at tip)"; empty when nothing moves by it.
std::string effectText(const Model& model, const JointVector& joints, std::size_t place,
                       double turn) {
  JointVector moved = joints;
  moved.values[place] += turn;
  applyMimics(model, moved);
  const std::vector<Mat4> before = linkPoses(model, joints), after = linkPoses(model, moved);
  double farthest_mm = 0;
  std::size_t link = 0;
  for (const std::size_t tip : tipLinks(model)) {
    const Vec3 apart = poseOf(after[tip]).position - poseOf(before[tip]).position;
    const double apart_mm = lengthOf(apart) * kMillimetres;
    if (apart_mm <= farthest_mm) continue;
    farthest_mm = apart_mm;
    link = tip;
  }
  if (farthest_mm < kLeastEffect_mm) return {};
  return fmt::format(" ({} at {})", figureText(farthest_mm, "mm"), model.links[link].name);
}

}  // namespace

void tellToolEffects(const Cell& cell, const SessionTrack& run, RunJudgement& judged) {
  // By device, whose motion is read once.
  std::map<std::string, std::vector<RunFinding*>> findings;
  std::size_t count = 0;
  for (RunFinding& finding : judged.findings) {
    const bool is_turn = finding.kind == RunFinding::Kind::joint && finding.unit == "°";
    if (!is_turn || !finding.largest || *finding.largest > kMostTurn_deg) continue;
    if (++count > kMostEffects) break;
    findings[finding.item.substr(0, finding.item.find('/'))].push_back(&finding);
  }
  for (const auto& [name, its] : findings) {
    const CellDevice* const device = cell.findDevice(name);
    const Model* const model = device == nullptr ? nullptr : cell.modelOf(*device);
    const auto track = run.devices.find(name);
    if (model == nullptr || track == run.devices.end() || !isOf(*model, track->second)) continue;
    const JointsOverTime motion(run, track->second, *model);
    for (RunFinding* const finding : its) {
      const std::string beginning =
          finding->item + ": " + figureText(*finding->largest, finding->unit);
      const auto place = motion.placeOf(std::string_view(finding->item).substr(name.size() + 1));
      const auto joints = motion.at(run.origin + finding->at_run);
      if (!place || !joints || !finding->what.starts_with(beginning)) continue;
      finding->what.insert(beginning.size(),
                           effectText(*model, *joints, *place, *finding->largest / kDegrees));
    }
  }
  if (!judged.findings.empty()) judged.rule = runRule(judged);
}

}  // namespace rocinante
