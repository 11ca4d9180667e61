#include "viewer/ui/program/detail_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace rocinante {
namespace {

/// Threads that make coarser meshes; the others are left to drawing.
constexpr int kDetailThreads = 1;

int existingRung(int rung) { return std::clamp(rung, 0, kCoarsestRung); }

}  // namespace

DetailChoice::DetailChoice(std::optional<int> fixed, bool may_govern, double target_fps)
    : governor_({1000 / target_fps, kCoarsestRung}),
      target_fps_(target_fps),
      may_govern_(may_govern),
      fixed_(fixed.has_value() || !may_govern),
      rung_(existingRung(fixed.value_or(0))) {}

bool DetailChoice::prepare(Renderer& renderer) {
  const DetailRung& rung = kDetailRungs[static_cast<std::size_t>(rung_)];
  const bool wanted = rung.level.geometry_error_px > 0;
  if (!wanted && fixed_) return false;
  renderer.prepareDetail(DetailCache::ofUser(), kDetailThreads);
  const bool news = renderer.takeReadyDetail(wanted && fixed_);
  if (news) governor_.forget();
  coarse_ready_ = renderer.detailReady();
  return news;
}

void DetailChoice::apply(const ViewerRequests& requests) {
  if (requests.target_fps) {
    target_fps_ = *requests.target_fps;
    governor_.setTarget(1000 / target_fps_);
  }
  if (requests.rung) {
    fixed_ = *requests.rung >= 0;
    governor_.allowAll();
    rung_ = existingRung(fixed_ ? *requests.rung : governor_.rung());
    governor_.forget();
  }
}

void DetailChoice::setLooksByDefault(bool any) {
  if (any == looks_by_default_) return;
  looks_by_default_ = any;
  governor_.setDropsLooks(any);
}

void DetailChoice::frameDrawn(double cost_ms) {
  if (!fixed_) rung_ = existingRung(governor_.frameDrawn(cost_ms));
}

void DetailChoice::begin(int rung, double cost_ms) {
  if (fixed_) return;
  governor_.begin(rung, cost_ms);
  rung_ = existingRung(governor_.rung());
}

void DetailChoice::beginAt(int rung) {
  if (fixed_) return;
  governor_.beginAt(rung);
  rung_ = existingRung(governor_.rung());
}

void DetailChoice::tell(ViewerStatus& status) const {
  status.rung = rung_;
  status.rung_fixed = fixed_;
  status.may_govern = may_govern_;
  status.target_fps = target_fps_;
  status.coarse_ready = coarse_ready_;
  status.drops_looks = looks_by_default_ && dropsLooks();
}

std::string runawayText(const Governor::Runaway& runaway) {
  const std::string took = fmt::format("a frame took {:.1f} s after {:.0f} ms",
                                       runaway.cost_ms / 1000, runaway.typical_ms);
  if (runaway.with_looks) return took + ": shadows and contact are off (D turns shadows on)";
  return fmt::format("{}: level {} is not drawn any more (`detail auto` tries again)", took,
                     runaway.rung);
}

}  // namespace rocinante
