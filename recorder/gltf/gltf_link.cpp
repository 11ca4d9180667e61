#include "recorder/gltf/gltf_link.h"

#include <fmt/format.h>

#include "core/base/version.h"
#include "core/foreign/session/link_frames.h"
#include "core/math/transform.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

// Metres. glTF gives perspective cameras no end of view; orthographic ones need both.
constexpr double kNear = 0.01, kFar = 10000;
constexpr double kPi = 3.14159265358979323846;

}  // namespace

std::optional<Pose> gltfCameraPose(const PosedCamera& camera) {
  const auto back = normalized(camera.eye - camera.target);
  if (!back) return std::nullopt;
  const auto right = normalized(crossOf(camera.up, *back));
  if (!right) return std::nullopt;
  const Vec3 up = crossOf(*back, *right);
  return poseOf(Mat4(Vec4(*right, 0), Vec4(up, 0), Vec4(*back, 0), Vec4(camera.eye, 1)));
}

Json gltfCamera(const PosedCamera& camera) {
  Json made;
  made["name"] = camera.name;
  Json lens;
  if (camera.ortho_height_m) {
    made["type"] = "orthographic";
    lens["xmag"] = lens["ymag"] = *camera.ortho_height_m / 2;
    lens["znear"] = 0;
    lens["zfar"] = kFar;
    made["orthographic"] = std::move(lens);
    return made;
  }
  made["type"] = "perspective";
  lens["yfov"] = camera.fov_deg * kPi / 180;
  lens["znear"] = kNear;
  made["perspective"] = std::move(lens);
  return made;
}

Json gltfWorld() {
  Json world;
  world["name"] = std::string(kWorldFrame);
  world["matrix"] = Json::array();
  for (const int part : {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1}) {
    world["matrix"].push_back(part);
  }
  return world;
}

std::vector<Json> gltfVisuals(GltfMeshes& meshes, const PosedDevice& device, std::size_t link) {
  std::vector<Json> nodes;
  const Link& of = device.model->links[link];
  for (std::size_t i = 0; i < of.visuals.size(); ++i) {
    const Visual& visual = of.visuals[i];
    const auto mesh = meshes.add(device, link, visual);
    if (!mesh) continue;
    Json node;
    node["name"] = fmt::format("{}#{}", frameName(device.name, of.name), i + 1);
    node["mesh"] = *mesh;
    const Vec3& at = visual.origin.position;
    const Quat& turn = visual.origin.orientation;
    const Vec3& scale = visual.scale;
    if (at != Vec3(0, 0, 0)) node["translation"] = {at.x, at.y, at.z};
    if (turn != Quat(1, 0, 0, 0)) node["rotation"] = {turn.x, turn.y, turn.z, turn.w};
    if (scale != Vec3(1, 1, 1)) node["scale"] = {scale.x, scale.y, scale.z};
    nodes.push_back(std::move(node));
  }
  return nodes;
}

Result<Bytes> gltfOfLink(const PosedDevice& device, std::size_t link,
                         std::vector<std::string>& gaps) {
  GltfBinary binary;
  GltfMaterials materials(binary);
  GltfMeshes meshes(binary, materials);
  Json nodes = Json::array();
  nodes.push_back(gltfWorld());
  for (Json& visual : gltfVisuals(meshes, device, link)) {
    nodes[0]["children"].push_back(nodes.size());
    nodes.push_back(std::move(visual));
  }
  gaps.insert(gaps.end(), materials.gaps().begin(), materials.gaps().end());
  if (nodes.size() == 1) return Bytes{};
  Json document;
  document["asset"]["version"] = "2.0";
  document["asset"]["generator"] = version();
  document["scene"] = 0;
  Json scene;
  scene["nodes"] = Json::array({0});
  document["scenes"] = Json::array();
  document["scenes"].push_back(std::move(scene));
  document["nodes"] = std::move(nodes);
  meshes.describe(document);
  materials.describe(document);
  binary.describe(document);
  Bytes glb;
  const std::unique_ptr<ByteSink> sink = makeMemorySink(glb);
  if (Status written = binary.write(*sink, document); !written) return written.error();
  return glb;
}

}  // namespace rocinante
