#include "core/check/judges/layer_judge.h"

#include <fmt/format.h>

#include "core/base/name_hint.h"
#include "core/cell/layer_index.h"

namespace rocinante {
namespace {

/// Most layers that are counted separately; only a hostile session has more.
constexpr std::size_t kMaxLayerNames = 200;

}  // namespace

LayerJudge::LayerJudge(const Cell& cell) : layers_(layerNames(cell)) {}

void LayerJudge::judge(std::string_view layer, const PacketPlace& place) {
  if (layers_.contains(layer)) return;
  auto found = unknown_.find(layer);
  if (found == unknown_.end()) {
    if (unknown_.size() == kMaxLayerNames) return;
    found = unknown_.emplace(std::string(layer), Tally()).first;
  }
  found->second.hit(place);
}

void LayerJudge::report(Findings& findings) const {
  for (const auto& [layer, tally] : unknown_) {
    findings.push_back(tally.finding("packet.unknown-layer", layer,
                                     fmt::format("the cell has no layer {}", layer)));
    findings.back().hint = whatThereIs(layer, {layers_.begin(), layers_.end()});
  }
}

}  // namespace rocinante
