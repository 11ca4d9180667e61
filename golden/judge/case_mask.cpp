#include "golden/judge/case_mask.h"

#include <algorithm>

#include "core/base/pattern.h"

namespace rocinante {
namespace {

std::size_t pixelCount(const SuiteCase& made) {
  return static_cast<std::size_t>(made.width) * static_cast<std::size_t>(made.height);
}

PixelSet rectanglePixels(const SuiteCase& made, const MaskRectangle& rectangle) {
  PixelSet set(pixelCount(made));
  const int right = std::min(made.width, rectangle.x + rectangle.width);
  const int bottom = std::min(made.height, rectangle.y + rectangle.height);
  for (int y = rectangle.y; y < bottom; ++y) {
    for (int x = rectangle.x; x < right; ++x) {
      set[static_cast<std::size_t>(y) * static_cast<std::size_t>(made.width) +
          static_cast<std::size_t>(x)] = 1;
    }
  }
  return set;
}

PixelSet pixelsOf(const SuiteCase& made, const PictureArea& area, const SceneIdentity* identity) {
  if (area.rectangle) {
    const MaskRectangle& given = *area.rectangle;
    const int left = std::max(0, given.x - area.grow_px);
    const int top = std::max(0, given.y - area.grow_px);
    return rectanglePixels(made, {left, top, given.x + given.width + area.grow_px - left,
                                  given.y + given.height + area.grow_px - top});
  }
  if (identity == nullptr) return PixelSet(pixelCount(made));
  const IdentityFrame& frame = identity->frame;
  std::vector<bool> wanted(frame.names.size() + 1);  // 0 is nothing
  for (std::size_t i = 0; i < frame.names.size(); ++i) {
    wanted[i + 1] = pathNames(area.path, frame.names[i], identity->layers[i]);
  }
  // One more pixel: multisampling mixes an edge into its neighbours.
  return pixelsWithIds(frame.ids, wanted, frame.width, frame.height, 1 + area.grow_px);
}

/// One component of an areasPicture as a set.
PixelSet componentSet(const Picture& picture, std::size_t component) {
  PixelSet set(picture.rgba.size() / 4);
  for (std::size_t i = 0; i < set.size(); ++i) {
    set[i] = picture.rgba[i * 4 + component] != 0 ? 1 : 0;
  }
  return set;
}

}  // namespace

bool needsIdentity(const SuiteCase& made) {
  const auto names_path = [](const PictureArea& area) { return !area.rectangle; };
  return std::ranges::any_of(made.mask, names_path) ||
         std::ranges::any_of(made.judge_only, names_path);
}

bool pathNames(std::string_view path, const IdentityName& name,
               const std::vector<std::string>& layers) {
  if (path.starts_with("layer/")) {
    return std::ranges::any_of(
        layers, [&](const std::string& layer) { return patternMatches(path.substr(6), layer); });
  }
  return patternMatches(path, name.device + "/" + name.link) ||
         (path.find('/') == std::string_view::npos && patternMatches(path, name.device));
}

std::vector<std::string> layersOfLink(const PosedDevice& device, std::string_view link) {
  std::vector<std::string> layers;
  if (!device.layer.empty()) layers.push_back(device.layer);
  const auto found = device.model->findLink(link);
  for (const PosedShare& share : device.shares) {
    if (found && share.holds(*found)) layers.emplace_back(share.layer);
  }
  return layers;
}

CaseAreas findAreas(const SuiteCase& made, const SceneIdentity* identity) {
  CaseAreas areas;
  for (const PictureArea& area : made.mask) areas.masked.push_back(pixelsOf(made, area, identity));
  for (const PictureArea& area : made.judge_only) {
    const PixelSet more = pixelsOf(made, area, identity);
    if (areas.judged_only.empty()) {
      areas.judged_only = more;
    } else {
      unite(areas.judged_only, more);
    }
  }
  return areas;
}

Picture areasPicture(const SuiteCase& made, const CaseAreas& areas) {
  Picture picture{made.width, made.height, std::vector<std::uint8_t>(pixelCount(made) * 4)};
  for (std::size_t i = 0; i < pixelCount(made); ++i) {
    const bool masked =
        std::ranges::any_of(areas.masked, [&](const PixelSet& set) { return set[i] != 0; });
    const bool judged_only = !areas.judged_only.empty() && areas.judged_only[i] != 0;
    picture.rgba[i * 4] = masked ? 255 : 0;
    picture.rgba[i * 4 + 1] = judged_only ? 255 : 0;
    picture.rgba[i * 4 + 3] = 255;
  }
  return picture;
}

PictureMask maskOf(const SuiteCase& made, const CaseAreas& areas, const Picture* accepted) {
  if (accepted != nullptr && (accepted->width != made.width || accepted->height != made.height)) {
    accepted = nullptr;
  }
  PictureMask mask(made.width, made.height);
  for (std::size_t i = 0; i < areas.masked.size(); ++i) {
    mask.hide(areas.masked[i], made.mask[i].text());
  }
  if (accepted != nullptr && !areas.masked.empty()) {
    mask.hide(componentSet(*accepted, 0), "the masks of the golden");
  }
  if (!made.judge_only.empty()) {
    PixelSet judged = areas.judged_only;
    if (accepted != nullptr) unite(judged, componentSet(*accepted, 1));
    mask.hideOthers(std::move(judged), "judge_only");
  }
  return mask;
}

}  // namespace rocinante
