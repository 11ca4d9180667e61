#include "golden/judge/frame_coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/base/plain_text.h"
#include "core/cell/posed_scene.h"
#include "golden/judge/case_mask.h"
#include "golden/run/unfit_values.h"
#include "viewer/view/layer_choice.h"
#include "viewer/view/view_choice.h"

namespace rocinante {
namespace {

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
    if (fits) (view.looksAt(*device) ? coverage.judged : coverage.masked).insert(name);
  }
  coverage.left_out = std::move(track.left_out);
  return coverage;
}

std::set<std::string> lostSince(const AcceptedPicture& accepted, const RunCoverage& now) {
  std::set<std::string> lost;
  if (!accepted.coverage) return lost;
  for (const std::string& device : *accepted.coverage) {
    if (!now.judged.contains(device) && !now.masked.contains(device)) lost.insert(device);
  }
  return lost;
}

std::string lostSentence(const RunCoverage& coverage) {
  const std::string& device = *coverage.lost.begin();
  const std::string why = whyLeftOut(coverage.left_out, device);
  const std::size_t more = coverage.lost.size() - 1;
  return fmt::format("{}{}: not judged, since {}, though accepted", plainText(device),
                     more > 0 ? fmt::format(" and {} more", more) : "",
                     why.empty() ? "the log states no pose or joint of it by then" : why);
}

}  // namespace rocinante
