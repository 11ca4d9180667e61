#include "viewer/view/missing_meshes.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/plain_text.h"

namespace rocinante {

std::vector<std::string> linksWithoutMesh(const Cell& cell) {
  std::vector<std::string> names;
  for (const CellDevice& device : cell.devices) {
    const Model* const model = cell.modelOf(device);
    if (model == nullptr) {
      names.push_back(device.name);
      continue;
    }
    for (const Link& link : model->links) {
      const bool lacks =
          std::ranges::any_of(link.visuals, [](const Visual& visual) { return !visual.mesh; });
      if (lacks) names.push_back(device.name + "/" + link.name);
    }
  }
  return names;
}

std::string incompleteText(const Cell& cell) {
  constexpr std::size_t kMaxNamed = 3;
  const std::vector<std::string> names = linksWithoutMesh(cell);
  if (names.empty()) return {};
  std::string listed;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNamed); ++i) {
    listed += (i == 0 ? "" : ", ") + plainText(names[i]);
  }
  if (names.size() > kMaxNamed) listed += fmt::format(" and {} more", names.size() - kMaxNamed);
  std::string text =
      "the picture is incomplete: meshes of " + listed + " are missing or cannot be read";
  const auto first = std::ranges::find_if(cell.faults, [](const Finding& fault) {
    return fault.rule == "model.missing-file" || fault.rule == "model.unusable-mesh";
  });
  if (first != cell.faults.end()) text += ", first: " + first->text;
  return text;
}

}  // namespace rocinante
