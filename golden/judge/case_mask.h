#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "golden/compare/picture_mask.h"
#include "golden/suite/suite.h"
#include "viewer/render/identity_frame.h"

namespace rocinante {

/// The object shown by each pixel of a frame, and the layers of each object.
struct SceneIdentity {
  IdentityFrame frame;
  /// Per entry of frame.names: the layers that contain all of it; for drawings "lines", "points",
  /// "labels".
  std::vector<std::vector<std::string>> layers;
};

/// True when the case's areas name PATHs, so that an identity frame is needed to find them.
bool needsIdentity(const SuiteCase& made);

/// True when the pattern `path` (DEVICE, DEVICE/LINK, layer/NAME or drawing/SOURCE/ID) matches this
/// name.
bool pathNames(std::string_view path, const IdentityName& name,
               const std::vector<std::string>& layers);

/// The layers that contain all of a link.
std::vector<std::string> layersOfLink(const PosedDevice& device, std::string_view link);

/// The areas of a case in one picture.
struct CaseAreas {
  std::vector<PixelSet> masked;  ///< one for each `mask`
  PixelSet judged_only;          ///< union of all `judge_only`; empty when the case has none
};
/// `identity` may be null where no area names a PATH.
CaseAreas findAreas(const SuiteCase& made, const SceneIdentity* identity);

/// The areas as a picture of the frame's size, kept with a golden so that a part that moved is
/// still masked at its old place: red where masked, green where `judge_only`.
Picture areasPicture(const SuiteCase& made, const CaseAreas& areas);

/// The pixels not judged: masked now or in the golden; with `judge_only`, pixels in neither's
/// areas. `accepted` is the golden's areasPicture or null; one of a different size is ignored.
PictureMask maskOf(const SuiteCase& made, const CaseAreas& areas, const Picture* accepted);

}  // namespace rocinante
