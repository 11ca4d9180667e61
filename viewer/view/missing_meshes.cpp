#include "viewer/view/missing_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>

#include "core/base/plain_text.h"
#include "core/document/fault_list.h"

namespace rocinante {
namespace {

/// Not an image that is drawn nowhere: of an address, of a template, of a kind that is not read.
bool isFileName(std::string_view name) {
  const auto begins = [&](std::string_view scheme) { return name.starts_with(scheme); };
  constexpr std::array<std::string_view, 4> kNeverRead = {"http:", "https:", "ftp:", "$("};
  return !name.empty() && name != kUnreadImage && std::ranges::none_of(kNeverRead, begins);
}

/// The textures that its surfaces would have, were they found.
void addMissingTextures(const Visual& visual, std::set<std::string>& names) {
  if (!visual.mesh) return;
  const Mesh& mesh = *visual.mesh;
  const auto add = [&](const MeshPart& part) {
    const Material* const material = visual.material ? &*visual.material
                                     : part.material < mesh.materials.size()
                                         ? &mesh.materials[part.material]
                                         : nullptr;
    if (material != nullptr && part.index_count > 0 && isFileName(material->missing_map)) {
      names.insert(material->missing_map);
    }
  };
  if (visual.mesh_parts.empty()) {
    for (const MeshPart& part : mesh.parts) add(part);
  }
  for (const std::size_t part : visual.mesh_parts) {
    if (part < mesh.parts.size()) add(mesh.parts[part]);
  }
}

}  // namespace

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

std::vector<std::string> missingTextureTexts(const Cell& cell) {
  std::map<std::string, std::vector<std::string>> links;  // by texture
  for (const CellDevice& device : cell.devices) {
    const Model* const model = cell.modelOf(device);
    if (model == nullptr) continue;
    for (const Link& link : model->links) {
      std::set<std::string> names;
      for (const Visual& visual : link.visuals) addMissingTextures(visual, names);
      for (const std::string& name : names) links[name].push_back(device.name + "/" + link.name);
    }
  }
  std::vector<std::string> texts;
  for (const auto& [name, without] : links) {
    const bool is_one = without.size() == 1;
    texts.push_back(
        fmt::format("the texture {} is not found: {}{} drawn without it", quotedPathInFault(name),
                    plainText(without.front()),
                    is_one ? " is" : fmt::format(" and {} more are", without.size() - 1)));
  }
  return texts;
}

}  // namespace rocinante
