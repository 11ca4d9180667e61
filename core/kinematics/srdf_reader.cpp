#include "core/kinematics/srdf_reader.h"

#include <fmt/format.h>

#include <string_view>

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
  const std::string_view text = textOf(bytes);
  const XmlPlaces places(text);
  if (places.elementCount() > kMaxUrdfElements) {
    faults.error("urdf.too-many", {},
                 fmt::format("the file has more than {} elements", kMaxUrdfElements));
    return pairs;
  }
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  const tinyxml2::XMLElement* const robot = document.RootElement();
  if (document.Error() || robot == nullptr) {
    faults.error("urdf.xml", {document.ErrorLineNum(), 0},
                 "the XML of this SRDF file breaks off here, or there is none");
    return pairs;
  }
  places.attach(document);
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
