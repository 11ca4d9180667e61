#include "viewer/render/layer_choice.h"

#include <algorithm>
#include <array>

#include "core/model/layer_index.h"
#include "core/model/view_path.h"
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
  // Built-in ones hold no device: they are seen unless hidden.
  for (const std::string& layer : layers) show.push_back("layer/" + encodeName(layer));
}

Status checkLayers(const KnownLayers& known, const std::vector<std::string>& paths) {
  for (const std::string& text : paths) {
    const auto path = parseViewPath(text);
    if (!path || !path->path.is_layer || known.contains(path->path.second)) continue;
    std::string all;
    for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
    return Error{ErrorKind::not_found,
                 "no layer is called `" + path->path.second + "`: there are " + all,
                 {}};
  }
  return {};
}

Status checkLayers(const KnownLayers& known, const RenderStyle& style) {
  for (const auto* paths :
       {&style.outlined, &style.wireframe, &style.collision, &style.collision_over}) {
    if (Status fit = checkLayers(known, *paths); !fit) return fit;
  }
  for (const TransparentStyle& one : style.transparent) {
    if (Status fit = checkLayers(known, {one.path}); !fit) return fit;
  }
  return {};
}

}  // namespace rocinante
