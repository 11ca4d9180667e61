#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/behaviour/run_spec.h"
#include "core/behaviour/session_track.h"
#include "core/cell/cell.h"
#include "core/kinematics/kinematics.h"

namespace rocinante {

/// Links at the ends of a model's chains, but for those that nothing moves: where joints add up.
std::vector<std::size_t> tipLinks(const Model& model);

/// "DEVICE/LINK" of the links that are judged by themselves, sorted: where a limit of a position or
/// a turn is written, for the link; for its device or the run, at the ends of chains.
std::vector<std::string> linksToJudge(const RunSpec& spec, const Cell& cell);

/// Poses of some of a device's links in its own space.
class LinkPlacer {
 public:
  /// Empty when none of `links`, "DEVICE/LINK", is one of the device's. Borrows the model.
  static std::optional<LinkPlacer> of(std::string_view device, const Model& model,
                                      const std::vector<std::string>& links);

  /// A column for each, behind those that the series has.
  void addColumns(DeviceTrack& track, std::size_t series) const;
  /// `joints`: values in the model's order. Seven numbers a link go to `out`.
  void place(const double* joints, double* out);

 private:
  LinkPlacer(const Model& model, std::vector<std::size_t> links);

  const Model* model_;
  std::vector<std::size_t> links_;
  JointVector joints_;
};

}  // namespace rocinante
