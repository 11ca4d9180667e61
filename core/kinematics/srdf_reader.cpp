#include "core/kinematics/srdf_reader.h"

#include <fmt/format.h>

#include <string_view>

#include "core/document/xml_document.h"
#include "core/kinematics/urdf_element.h"
#include "core/kinematics/urdf_reader.h"

namespace rocinante {

std::vector<DisabledCollision> readSrdf(ByteView bytes, const std::filesystem::path& path,
                                        Findings& all_faults) {
  std::vector<DisabledCollision> pairs;
  FaultList faults(all_faults, path.string());
  if (bytes.size() > kMaxUrdfBytes) {
    faults.error("urdf.too-large", {},
                 fmt::format("the file is larger than {} MiB", kMaxUrdfBytes >> 20));
    return pairs;
  }
  const auto document =
      XmlDocument::parse(bytes, kMaxUrdfElements, {"urdf.xml", "urdf.too-many"}, faults);
  if (!document) return pairs;
  const XmlPlaces& places = document->places();
  const tinyxml2::XMLElement* const robot = &document->root();
  if (std::string_view(robot->Name()) != "robot") {
    faults.error("urdf.no-robot", places.of(*robot),
                 fmt::format("the outermost element is <{}>, where SRDF has <robot>",
                             std::string(std::string_view(robot->Name()).substr(0, 60))));
    return pairs;
  }
  const UrdfContext context{places, faults};
  bool is_full = false;
  UrdfElement(*robot, context).each("disable_collisions", [&](const UrdfElement& disabled) {
    if (is_full) return;
    is_full = pairs.size() == kMaxSrdfPairs;
    if (is_full) {
      faults.error("urdf.too-many", disabled.place(),
                   fmt::format("the file disables more than {} pairs of links: the rest is not "
                               "read",
                               kMaxSrdfPairs));
      return;
    }
    auto first = disabled.requiredText("link1");
    auto second = disabled.requiredText("link2");
    if (first && second) pairs.emplace_back(std::move(*first), std::move(*second));
  });
  return pairs;
}

}  // namespace rocinante
