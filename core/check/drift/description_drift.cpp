#include "core/check/drift/description_drift.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include "core/check/drift/model_drift.h"

namespace rocinante {
namespace {

constexpr std::array<std::string_view, 4> kLookRules{"drift.collision", "drift.geometry",
                                                     "drift.material", "drift.texture"};

}  // namespace

Findings descriptionDrift(const Cell& described, bool has_meshes, const Cell& given) {
  const Model* const robot =
      described.devices.empty() ? nullptr : described.modelOf(described.devices.front());
  if (robot == nullptr) return {};
  const auto model = std::make_shared<const Model>(*robot);
  // The given cell with that robot in place of its own.
  Cell recorded = given;
  std::size_t meant = 0;
  for (CellDevice& device : recorded.devices) {
    const Model* const own = given.modelOf(device);
    if (own == nullptr) continue;
    if (own->name != robot->name && given.devices.size() != 1) continue;
    device.dressed = model;
    ++meant;
  }
  if (meant == 0) return {};
  Findings findings = modelDrift(recorded, given);
  if (has_meshes) return findings;
  std::erase_if(findings, [](const Finding& finding) {
    return std::ranges::find(kLookRules, finding.rule) != kLookRules.end();
  });
  return findings;
}

}  // namespace rocinante
