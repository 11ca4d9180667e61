#pragma once

#include <optional>
#include <string>
#include <vector>

#include "golden/compare/picture_mask.h"
#include "golden/suite/suite.h"
#include "viewer/render/identity_frame.h"

namespace rocinante {

/// Whose pixels a frame shows, and of which layer each name is.
struct SceneIdentity {
  IdentityFrame frame;
  /// By frame.names: those that hold it whole; of drawings "lines", "points", "labels".
  std::vector<std::vector<std::string>> layers;
};

/// True when the case's areas name PATHs, so that an identity frame is needed to find them.
bool needsIdentity(const SuiteCase& made);

/// True when the glob `path` describes this name: DEVICE, DEVICE/LINK, layer/NAME or
/// drawing/SOURCE/ID.
bool pathNames(std::string_view path, const IdentityName& name,
               const std::vector<std::string>& layers);

/// Where the areas of a case lie in one picture.
struct CaseAreas {
  std::vector<PixelSet> masked;  ///< one for each `mask`
  PixelSet judged_only;          ///< of all `judge_only` together; empty when the case has none
};
/// `identity` may be null where no area names a PATH.
CaseAreas findAreas(const SuiteCase& made, const SceneIdentity* identity);

/// A golden remembers where its areas lay, so that a part that moved away is still masked where it
/// stood: as a picture of its size, red what was masked, green what alone was judged.
Picture areasPicture(const SuiteCase& made, const CaseAreas& areas);

/// What is not judged: masked now or then; with `judge_only`, what lies in neither's areas.
/// `accepted` is the golden's areasPicture, or null; another size than the case's counts as null.
PictureMask maskOf(const SuiteCase& made, const CaseAreas& areas, const Picture* accepted);

}  // namespace rocinante
