#include "golden/judge/frame_coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/base/plain_text.h"
#include "core/behaviour/unfit_values.h"
#include "core/cell/posed_scene.h"
#include "core/kinematics/joint_values.h"
#include "golden/judge/case_mask.h"
#include "viewer/view/view_choice.h"

namespace rocinante {
namespace {

constexpr std::string_view kAllJoints = "/*";

bool movesAnything(const DeviceState& state) {
  return state.pose || state.joints || !state.named_joints.empty();
}

/// Whether the case looks at some of a device, wherever it is in the picture.
class CaseView {
 public:
  explicit CaseView(const SuiteCase& made) : made_(made) {
    std::vector<std::string> hide = made.hide, show = made.show;
    if (made.layers) chooseLayers(*made.layers, hide, show);
    if (hide.empty()) return;
    if (auto choice = ViewChoice::make(hide, show); choice.ok()) choice_ = std::move(*choice);
  }

  bool looksAt(const PosedDevice& device) const { return isChosen(device) && !isMasked(device); }

 private:
  /// Whatever packets hide: that is the session's doing.
  bool isChosen(const PosedDevice& device) const {
    if (!choice_) return true;
    PosedDevice shown = device;
    shown.visible = true;
    shown.link_visible.assign(device.model->links.size(), true);
    for (std::size_t link = 0; link < device.model->links.size(); ++link) {
      if (choice_->linkVisible(shown, link)) return true;
    }
    return false;
  }

  bool isMasked(const PosedDevice& device) const {
    const auto isNamed = [&](const std::vector<PictureArea>& areas, const IdentityName& name,
                             const std::vector<std::string>& layers) {
      return std::ranges::any_of(areas, [&](const PictureArea& area) {
        return !area.rectangle && pathNames(area.path, name, layers);
      });
    };
    const bool judges_places = std::ranges::any_of(
        made_.judge_only, [](const PictureArea& area) { return area.rectangle.has_value(); });
    const bool judges_all = made_.judge_only.empty() || judges_places;
    if (made_.mask.empty() && judges_all) return false;
    for (const Link& link : device.model->links) {
      const IdentityName name{device.name, link.name};
      const std::vector<std::string> layers = layersOfLink(device, link.name);
      if (isNamed(made_.mask, name, layers)) continue;
      if (judges_all || isNamed(made_.judge_only, name, layers)) return false;
    }
    return true;
  }

  const SuiteCase& made_;
  std::optional<ViewChoice> choice_;
};

/// Why a device of which packets state something is not drawn; empty: packets removed it.
std::string whyAbsent(const Cell& cell, const std::string& name, const DeviceState& state) {
  if (state.presence && state.presence->value.presence == Presence::removed) return {};
  const CellDevice* device = cell.findDevice(name);
  if (device == nullptr) return "the cell has no such device";
  return device->optional && !state.presence ? "it is optional, and no packet added it"
                                             : "its model cannot be read";
}

/// The joint values of a drawn device that the session states.
void addJoints(const std::string& device, const Model& model, const DeviceState& stated,
               RunCoverage& coverage) {
  if (!stated.joints && stated.named_joints.empty()) return;
  std::vector<std::string> judged, unstated;
  for (const std::string& value : positionalNames(model)) {
    const bool is_stated = stated.joints || stated.named_joints.contains(value);
    (is_stated ? judged : unstated).push_back(device + "/" + value);
  }
  if (unstated.empty() && !judged.empty()) judged = {device + std::string(kAllJoints)};
  coverage.judged.insert(judged.begin(), judged.end());
  if (!judged.empty()) coverage.unstated.insert(unstated.begin(), unstated.end());
}

/// Whether the frame judges some joint of it.
bool judgesJoints(const RunCoverage& coverage, const std::string& device) {
  const auto first = coverage.judged.lower_bound(device + "/");
  return first != coverage.judged.end() && first->starts_with(device + "/");
}

}  // namespace

RunCoverage frameCoverage(const SuiteCase& made, const Cell& cell, const SessionState& state,
                          LogTime origin) {
  SessionTrack track;
  track.origin = origin;
  UnfitValues unfit(track);
  const PosedScene scene = poseScene(cell, state);
  const CaseView view(made);
  RunCoverage coverage;
  for (const auto& [name, stated] : state.devices()) {
    if (!movesAnything(stated)) continue;
    const PosedDevice* const device = scene.findDevice(name);
    if (device == nullptr) {
      const std::string why = whyAbsent(cell, name, stated);
      if (!why.empty()) unfit.leaveOut("device", name, why, stated.last_write);
      continue;
    }
    const std::uint64_t before = track.left_out.total();
    unfit.takesValues(name, *device->model, stated);
    const bool fits = track.left_out.total() == before;
    if (!view.looksAt(*device)) {
      if (fits) coverage.masked.insert(name);
      continue;
    }
    if (fits) coverage.judged.insert(name);
    // Of a wrong number of values none is taken.
    const bool is_taken =
        !stated.joints || stated.joints->value.size() == device->model->positionalCount();
    if (is_taken) addJoints(name, *device->model, stated, coverage);
  }
  coverage.left_out = std::move(track.left_out);
  return coverage;
}

std::string coveredText(const std::string& item) {
  if (!item.ends_with(kAllJoints)) return plainText(item);
  return plainText(item.substr(0, item.size() - kAllJoints.size())) + " (its joints)";
}

std::set<std::string> lostSince(const AcceptedPicture& accepted, const RunCoverage& now) {
  std::set<std::string> lost;
  if (!accepted.coverage) return lost;
  const std::set<std::string> items(accepted.coverage->begin(), accepted.coverage->end());
  for (const std::string& item : items) {
    const std::size_t slash = item.find('/');
    const std::string device = item.substr(0, slash);
    if (now.judged.contains(item) || now.masked.contains(device)) continue;
    const bool judges_joints = judgesJoints(now, device);
    if (slash == std::string::npos) {
      // Where values of it are still judged, the others are named.
      const auto first = items.lower_bound(device + "/");
      const bool had_joints = first != items.end() && first->starts_with(device + "/");
      if (!judges_joints || !had_joints) lost.insert(item);
      continue;
    }
    if (!judges_joints) {
      if (now.judged.contains(device)) lost.insert(device + std::string(kAllJoints));
    } else if (item.ends_with(kAllJoints)) {
      for (auto its = now.unstated.lower_bound(device + "/");
           its != now.unstated.end() && its->starts_with(device + "/"); ++its) {
        lost.insert(*its);
      }
    } else if (!now.judged.contains(device + std::string(kAllJoints))) {
      lost.insert(item);
    }
  }
  return lost;
}

std::string lostSentence(const RunCoverage& coverage) {
  const std::string& item = *coverage.lost.begin();
  const bool is_device = item.find('/') == std::string::npos;
  std::string why = is_device ? whyLeftOut(coverage.left_out, item) : "";
  if (why.empty()) {
    why = is_device ? "the log states no pose or joint of it by then"
                    : "the log states no value of it by then";
  }
  const std::size_t more = coverage.lost.size() - 1;
  return fmt::format("{}{}: not judged, since {}, though accepted", coveredText(item),
                     more > 0 ? fmt::format(" and {} more", more) : "", why);
}

}  // namespace rocinante
