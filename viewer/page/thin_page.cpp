#include <fmt/format.h>

#include <algorithm>

#include "core/base/figure_text.h"
#include "viewer/page/page_job.h"
#include "viewer/page/page_parts.h"

namespace rocinante {
namespace {

constexpr int kLargestSide = 2048, kLeastSide = 64;

bool hasPictures(const Cell& cell) {
  const auto has = [](const Model& model) {
    return std::ranges::any_of(model.links, [](const Link& link) {
      return std::ranges::any_of(link.visuals, [](const Visual& visual) {
        if (visual.material && !visual.material->diffuse_map.empty()) return true;
        return visual.mesh &&
               std::ranges::any_of(visual.mesh->materials, [](const Material& material) {
                 return !material.diffuse_map.empty();
               });
      });
    });
  };
  return std::ranges::any_of(cell.models,
                             [&](const auto& named) { return named.second && has(*named.second); });
}

std::string leftOut(const Thinness& thinness, bool has_pictures, std::size_t whole_bytes) {
  std::string text = "Made smaller for a page of ";
  text += sizeText(whole_bytes) + ":";
  if (has_pictures) {
    text += fmt::format(" pictures have at most {} pixels a side", thinness.largest_side);
  }
  if (has_pictures && thinness.halvings > 0) text += ",";
  if (thinness.halvings > 0) {
    text += fmt::format(" meshes about 1/{} of their triangles", 1 << thinness.halvings);
  }
  return text + ".";
}

}  // namespace

std::string thinPage(const Cell& cell, const PageJob& job, std::size_t whole_bytes,
                     PageParts& parts) {
  const bool has_pictures = hasPictures(cell);
  std::string page;
  Thinness thinness;
  for (int side = kLargestSide; side >= kLeastSide; side /= 2) {
    thinness.largest_side = side;
    for (const bool coarser : {false, true}) {
      if (coarser) ++thinness.halvings;
      if (!coarser && !has_pictures) continue;
      parts.cell = pageCell(cell, thinness, job.parallel);
      parts.left_out = leftOut(thinness, has_pictures, whole_bytes);
      page = pageOf(parts);
      if (page.size() <= job.most_bytes) return page;
    }
  }
  return page;
}

}  // namespace rocinante
