#include "viewer/view/layer_choice.h"

#include <algorithm>
#include <array>

#include "core/cell/layer_index.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

constexpr std::array kBuiltIn{"gnomon", "grid", "labels", "lines", "points"};

}  // namespace

KnownLayers knownLayers(const Cell& cell) {
  KnownLayers known = layerNames(cell);
  known.insert(kBuiltIn.begin(), kBuiltIn.end());
  return known;
}

void chooseLayers(const std::vector<std::string>& layers, std::vector<std::string>& hide,
                  std::vector<std::string>& show) {
  hide.emplace_back("*");
  for (const char* name : kBuiltIn) {
    if (std::ranges::find(layers, name) == layers.end()) {
      hide.push_back(std::string("layer/") + name);
    }
  }
  // Built-in layers contain no device: they are visible unless hidden.
  for (const std::string& layer : layers) show.push_back("layer/" + encodeName(layer));
}

}  // namespace rocinante
