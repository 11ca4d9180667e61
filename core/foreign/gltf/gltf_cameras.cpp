#include "core/foreign/gltf/gltf_cameras.h"

#include "core/math/transform.h"

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

}  // namespace rocinante
