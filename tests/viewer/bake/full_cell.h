#pragma once

#include <memory>
#include <utility>

#include "core/cell/cell.h"

namespace rocinante::test {

inline std::shared_ptr<const Mesh> triangleMesh() {
  Mesh mesh;
  mesh.vertices = {{{0, 0, 0}, {0, 0, 1}, {0, 0}},
                   {{1, 0, 0}, {0, 0, 1}, {1, 0}},
                   {{0, 1, -0.0F}, {0, 0, 1}, {0, 1}}};
  mesh.indices = {0, 1, 2, 2, 1, 0};
  mesh.colors = {0xFF0000FF, 0x00FF00FF, 0x0000FFFF};
  mesh.parts = {{"front", 0, 0, 3}, {"back", 1, 3, 3}};
  Material painted;
  painted.name = "painted";
  painted.diffuse = {0.1F, 0.2F, 0.3F, 0.4F};
  painted.specular = {0.5F, 0.6F, 0.7F};
  painted.emission = {0.8F, 0.9F, 1.0F};
  painted.shininess = 12;
  painted.diffuse_map = "arm.glb#2";
  painted.missing_map = "gone.png";
  painted.diffuse_bytes = std::make_shared<const Bytes>(Bytes{std::byte{1}, std::byte{2}});
  painted.map_scale = {2, 3};
  painted.map_offset = {4, 5};
  painted.map_rotation = 0.5F;
  painted.wrap_u = TextureWrap::mirrored_repeat;
  painted.wrap_v = TextureWrap::clamp_to_edge;
  painted.alpha_mode = AlphaMode::mask;
  painted.alpha_cutoff = 0.25F;
  mesh.materials = {painted, Material{}};
  for (const Vertex& vertex : mesh.vertices) mesh.bounds.add(Vec3(vertex.position));
  mesh.shape = ShapeSize{ShapeSize::Kind::capsule, {0.1, 0.1, 0.3}};
  return std::make_shared<const Mesh>(std::move(mesh));
}

/// A base, an arm and a finger that follows it.
inline Model fullModel() {
  Model model;
  model.name = "arm";
  model.file = "arm.urdf";
  const auto mesh = triangleMesh();
  model.links.resize(3);
  model.links[0].name = "base";
  model.links[1].name = "upper";
  model.links[2].name = "finger";
  model.links[1].parent_joint = 0;
  model.links[2].parent_joint = 1;
  Visual visual;
  visual.name = "shell";
  visual.origin = {{0.1, 0.2, 0.3}, {0.5, 0.5, 0.5, 0.5}};
  visual.scale = {1, -2, 3};
  visual.mesh = mesh;
  visual.mesh_parts = {1};
  visual.material = mesh->materials[0];
  model.links[0].visuals = {visual, Visual{}};
  model.links[1].visuals = {visual};
  model.links[1].collisions = {visual};
  Joint shoulder;
  shoulder.name = "shoulder";
  shoulder.type = JointType::revolute;
  shoulder.parent = 0;
  shoulder.child = 1;
  shoulder.origin = {{1.0 / 3, 0, 1e-300}, {0.6, 0, 0.8, 0}};
  shoulder.axis = {0, 1, 0};
  shoulder.limits = JointLimits{-1, 2, 3.0, 4.0};
  Joint follower = shoulder;
  follower.name = "follower";
  follower.parent = 1;
  follower.child = 2;
  follower.mimic = Mimic{0, -2, 0.5};
  model.joints = {shoulder, follower};
  model.root = 0;
  model.update_order = {0, 1};
  model.link_by_name = {{"base", 0}, {"upper", 1}, {"finger", 2}};
  model.joint_by_name = {{"shoulder", 0}, {"follower", 1}};
  return model;
}

/// A cell in which no field has its default.
inline Cell fullCell() {
  Cell cell;
  cell.file = "full.cell.toml";
  cell.models["arm"] = std::make_shared<const Model>(fullModel());
  cell.models["arm.urdf"] = cell.models["arm"];
  cell.models["unusable"] = nullptr;
  CellDevice device;
  device.name = "left";
  device.model = "arm";
  device.pose = {{1, 2, 3}, {0, 1, 0, 0}};
  device.layer = "arms";
  device.tags = {"moving", "red"};
  device.optional = true;
  device.on_device = "carriage";
  device.on_link = "plate";
  device.color = glm::vec4(0.1F, 0.2F, 0.3F, 1.0F);
  device.dressed = std::make_shared<const Model>(fullModel());
  cell.devices = {device, CellDevice{}};
  cell.device_by_name = {{"left", 0}};
  cell.cameras = {{"near",
                   {1, 2, 3},
                   {4, 5, 6},
                   {0, 1, 0},
                   33,
                   2.5,
                   "left",
                   "upper",
                   "a",
                   "b",
                   "c",
                   "d",
                   CameraIntrinsics{700, 701, 319, 239, 640, 480},
                   LensDistortion{0.1, 0.2, 0.3, 0.4, 0.5}}};
  CellInset inset;
  inset.camera = "near";
  inset.corner = InsetCorner::bottom_left;
  inset.width = 100;
  inset.height = 80;
  inset.in_pixels = true;
  inset.margin_px = 3;
  inset.title = "";
  inset.border_px = 2;
  inset.border_rgba = 0x11223344;
  cell.insets = {inset};
  LayerLook look;
  look.wireframe = true;
  look.opacity = 0.5F;
  look.collision = CollisionLook::over;
  cell.layers = {{"arms", false, {{"left", "upper", "front*"}}, look}};
  CellSource source;
  source.name = "plc";
  source.rate_hz = {10, 20};
  source.limits = {1.0, 2.0, 3.0, 4.0};
  source.devices = {"left"};
  source.ghost_of = {{"planned", "left"}};
  cell.sources = {source};
  cell.rules = {{"packet.gap",
                 true,
                 Severity::warning,
                 "ms",
                 5,
                 {{"arm", {"ms", 6}}},
                 "full.cell.toml",
                 6,
                 7}};
  cell.clearances = {{"apart", {"a/*", "b"}, true, 0.1, {{"a/x", "b/y"}}}};
  cell.signals = {{"left",
                   "upper",
                   "force*",
                   "N",
                   "Force",
                   std::pair(-1.0, 2.0),
                   3.0,
                   4.0,
                   std::pair(5.0, 6.0),
                   {"a", "b"},
                   {{"a", "b"}},
                   true}};
  cell.scene.background_top = {0.1F, 0.2F, 0.3F};
  cell.scene.background_bottom = {0.4F, 0.5F, 0.6F};
  cell.scene.light_direction = {1, 2, 3};
  cell.scene.lights = {{{1, 2, 3}, {0.1F, 0.2F, 0.3F}, 0.5}};
  cell.scene.grid = false;
  cell.scene.grid_size_m = 20;
  cell.scene.grid_step_m = 2;
  Finding fault;
  fault.rule = "cell.unknown-key";
  fault.severity = Severity::warning;
  fault.text = "unknown key";
  fault.hint = "did you mean";
  fault.file = "full.cell.toml";
  fault.line = 3;
  fault.column = 4;
  fault.byte = 5;
  fault.count = 6;
  fault.subject = "left";
  fault.example = "joints";
  fault.accepted = true;
  cell.faults = {fault};
  cell.files = {"arm.urdf", "full.cell.toml"};
  cell.files_below = "/below/";
  cell.files_shown_as = "log:cell/";
  return cell;
}

}  // namespace rocinante::test
