#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/mesh/shapes.h"

namespace rocinante::test {

/// A flat square in the plane y = 0, seen from -y: `size` metres wide, v up.
inline Mesh squareMesh(double size) {
  const auto h = static_cast<float>(size / 2);
  Mesh mesh;
  const glm::vec3 normal(0, -1, 0);
  mesh.vertices = {{{-h, 0, -h}, normal, {0, 0}},
                   {{h, 0, -h}, normal, {1, 0}},
                   {{h, 0, h}, normal, {1, 1}},
                   {{-h, 0, h}, normal, {0, 1}}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.parts = {{"square", 0, 0, 6}};
  mesh.materials = {Material{}};
  for (const Vertex& vertex : mesh.vertices) mesh.bounds.add(Vec3(vertex.position));
  return mesh;
}

inline Material colored(float r, float g, float b, float a = 1) {
  Material material;
  material.diffuse = {r, g, b, a};
  return material;
}

/// A cell whose devices are each one link with one mesh, placed by their pose.
class TestCell {
 public:
  TestCell() {
    cell_.scene.grid = false;
    cell_.scene.background_top = cell_.scene.background_bottom = {0, 0, 0};
    // Straight at what the camera of these tests looks at.
    cell_.scene.light_direction = {0, -1, 0};
  }

  TestCell& add(const std::string& name, Mesh mesh, const Vec3& at,
                std::optional<Material> material = {}, const std::string& layer = {}) {
    auto model = std::make_shared<Model>();
    model->name = name;
    Link link;
    link.name = "body";
    Visual visual;
    visual.mesh = std::make_shared<const Mesh>(std::move(mesh));
    visual.material = std::move(material);
    link.visuals.push_back(std::move(visual));
    model->links.push_back(std::move(link));
    cell_.models[name] = model;
    CellDevice device;
    device.name = name;
    device.model = name;
    device.pose.position = at;
    device.layer = layer;
    cell_.devices.push_back(std::move(device));
    return *this;
  }

  Cell& cell() { return cell_; }
  PosedScene scene() const { return poseScene(cell_, SessionState{}); }

 private:
  Cell cell_;
};

}  // namespace rocinante::test
