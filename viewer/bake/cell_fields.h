#pragma once

#include <cstdint>

#include "core/base/struct_wire.h"
#include "core/cell/cell.h"

// What the structs of a cell consist of, in the order of docs/baked-cell.md; for FieldWriter and
// FieldReader alike. Each takes its struct apart by a structured binding: a member that is added to
// the struct does not compile here until it is baked too (and BakedFile::kFormat counted up).

namespace rocinante {

inline std::uint8_t enumeratorCount(InsetCorner) { return 4; }
inline std::uint8_t enumeratorCount(CollisionLook) { return 3; }
inline std::uint8_t enumeratorCount(Severity) { return 3; }
inline std::uint8_t enumeratorCount(JointType) { return 6; }
inline std::uint8_t enumeratorCount(ShapeSize::Kind) { return 4; }
inline std::uint8_t enumeratorCount(AlphaMode) { return 3; }
inline std::uint8_t enumeratorCount(TextureWrap) { return 3; }

template <class Fields>
void fields(Fields& io, Taken<Fields, Pose>& pose) {
  auto& [position, orientation] = pose;
  io(position, orientation);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Bounds>& bounds) {
  auto& [min, max] = bounds;
  io(min, max);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, ShapeSize>& shape) {
  auto& [kind, size] = shape;
  io(kind, size[0], size[1], size[2]);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Material>& material) {
  auto& [name, diffuse, specular, emission, shininess, diffuse_map, missing_map, diffuse_bytes,
         map_scale, map_offset, map_rotation, wrap_u, wrap_v, alpha_mode, alpha_cutoff] = material;
  io(name, diffuse, specular, emission, shininess, diffuse_map, missing_map, diffuse_bytes,
     map_scale, map_offset, map_rotation, wrap_u, wrap_v, alpha_mode, alpha_cutoff);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, MeshPart>& part) {
  auto& [group, material, first_index, index_count] = part;
  io(group, material, first_index, index_count);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Mesh>& mesh) {
  auto& [vertices, indices, colors, parts, materials, bounds, shape] = mesh;
  io(vertices, indices, colors, parts, materials, bounds, shape);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, JointLimits>& limits) {
  auto& [lower, upper, velocity, effort] = limits;
  io(lower, upper, velocity, effort);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Mimic>& mimic) {
  auto& [joint, multiplier, offset] = mimic;
  io(joint, multiplier, offset);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Joint>& joint) {
  auto& [name, type, parent, child, origin, axis, limits, mimic] = joint;
  io(name, type, parent, child, origin, axis, limits, mimic);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Visual>& visual) {
  auto& [name, origin, scale, mesh, mesh_parts, material] = visual;
  io(name, origin, scale, mesh, mesh_parts, material);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Link>& link) {
  auto& [name, parent_joint, visuals, collisions] = link;
  io(name, parent_joint, visuals, collisions);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Model>& model) {
  auto& [name, file, links, joints, root, update_order, link_by_name, joint_by_name] = model;
  io(name, file, links, joints, root, update_order, link_by_name, joint_by_name);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellDevice>& device) {
  auto& [name, model, pose, layer, tags, optional, on_device, on_link, color, dressed] = device;
  io(name, model, pose, layer, tags, optional, on_device, on_link, color, dressed);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellCamera>& camera) {
  auto& [name, eye, target, up, fov_deg, ortho_height_m, on_device, on_link, follow_device,
         follow_link, look_device, look_link, intrinsics, distortion] = camera;
  io(name, eye, target, up, fov_deg, ortho_height_m, on_device, on_link, follow_device, follow_link,
     look_device, look_link, intrinsics, distortion);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CameraIntrinsics>& lens) {
  auto& [fx, fy, cx, cy, width, height] = lens;
  io(fx, fy, cx, cy, width, height);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, LensDistortion>& lens) {
  auto& [k1, k2, p1, p2, k3] = lens;
  io(k1, k2, p1, p2, k3);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellInset>& inset) {
  auto& [camera, corner, width, height, in_pixels, margin_px, title, border_px, border_rgba] =
      inset;
  io(camera, corner, width, height, in_pixels, margin_px, title, border_px, border_rgba);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, LayerLook>& look) {
  auto& [wireframe, opacity, collision] = look;
  io(wireframe, opacity, collision);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, LayerMember>& member) {
  auto& [device, link, group] = member;
  io(device, link, group);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellLayer>& layer) {
  auto& [name, visible, members, look] = layer;
  io(name, visible, members, look);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, SourceLimits>& limits) {
  auto& [silence_s, restate_s, clock_skew_s, jitter_ms] = limits;
  io(silence_s, restate_s, clock_skew_s, jitter_ms);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellSource>& source) {
  auto& [name, rate_hz, limits, devices, ghost_of] = source;
  io(name, rate_hz, limits, devices, ghost_of);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellThreshold>& threshold) {
  auto& [key, value] = threshold;
  io(key, value);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellRule>& rule) {
  auto& [id, is_off, severity, threshold_key, threshold, own_thresholds, file, line, column] = rule;
  io(id, is_off, severity, threshold_key, threshold, own_thresholds, file, line, column);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellClearance>& clearance) {
  auto& [name, between, is_self, min_m, except] = clearance;
  io(name, between, is_self, min_m, except);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellSignal>& signal) {
  auto& [device, link, name, unit, label, range, jump, stuck_s, rate_hz, values, transitions,
         optional] = signal;
  io(device, link, name, unit, label, range, jump, stuck_s, rate_hz, values, transitions, optional);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellLight>& light) {
  auto& [direction, color, strength] = light;
  io(direction, color, strength);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellScene>& scene) {
  auto& [background_top, background_bottom, light_direction, lights, grid, grid_size_m,
         grid_step_m] = scene;
  io(background_top, background_bottom, light_direction, lights, grid, grid_size_m, grid_step_m);
}

/// Of a file: what only findings of a session have (times, packets) is not baked.
template <class Fields>
void fields(Fields& io, Taken<Fields, Finding>& fault) {
  auto& [rule, severity, text, hint, left_out, file, line, column, byte, count, first, last, when,
         packet, subject, example, worst, accepted] = fault;
  io(rule, severity, text, hint, left_out, file, line, column, byte, count, subject, example,
     accepted);
}

/// All but what models and pictures have sections of their own for, what keeps files and memory,
/// and what a session without a cell has.
template <class Fields>
void fields(Fields& io, Taken<Fields, Cell>& cell) {
  auto& [file, devices, device_by_name, models, cameras, insets, layers, sources, rules, clearances,
         signals, scene, decoders, faults, files, keeps_files, files_below, files_shown_as,
         pictures, keeps_pictures, bare_model] = cell;
  io(file, devices, device_by_name, models, cameras, insets, layers, sources, rules, clearances,
     signals, scene, decoders, faults, files, files_below, files_shown_as);
}

}  // namespace rocinante
