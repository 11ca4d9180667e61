#include "tests/bench/render/bench_scenes.h"

#include <cmath>
#include <fstream>

#include "core/cell/posed_scene.h"
#include "core/math/transform.h"
#include "core/packet/decoder.h"
#include "viewer/picture/picture.h"

namespace rocinante::bench {
namespace {

constexpr int kWide = 217, kHigh = 73;  // 2 * 217 * 73 = 31,682 triangles
constexpr int kPictureSide = 1024;

Mesh pyramid(float height) {
  Mesh mesh;
  const Vec3 top(0, 0, height);
  for (int side = 0; side < 4; ++side) {
    const double x[] = {-0.5, 0.5, 0.5, -0.5};
    const double y[] = {-0.5, -0.5, 0.5, 0.5};
    const int next = (side + 1) % 4;
    const Vec3 a(x[side], y[side], 0);
    const Vec3 b(x[next], y[next], 0);
    const Vec3 normal = crossOf(b - a, top - a);
    const glm::vec3 unit(normal / lengthOf(normal));
    for (const Vec3& corner : {a, b, top}) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back({glm::vec3(corner), unit, {0, 0}});
      mesh.bounds.add(corner);
    }
  }
  mesh.parts = {{"pyramid", 0, 0, 12}};
  mesh.materials = {Material{}};
  return mesh;
}

Cell cellOf(std::shared_ptr<const Model> model) {
  Cell cell;
  cell.scene.grid = false;
  CellDevice device;
  device.name = device.model = model->name;
  cell.models[model->name] = std::move(model);
  cell.devices.push_back(std::move(device));
  return cell;
}

}  // namespace

Result<std::filesystem::path> writeHills(const std::filesystem::path& folder) {
  Picture picture{kPictureSide, kPictureSide, {}};
  for (int y = 0; y < kPictureSide; ++y) {
    for (int x = 0; x < kPictureSide; ++x) {
      const int shade = ((x >> 5 ^ y >> 5) & 1) * 60 + (x * 7 + y * 13) % 64;
      for (const int component : {90 + shade, 110 + shade, 70 + shade / 2, 255}) {
        picture.rgba.push_back(static_cast<std::uint8_t>(component));
      }
    }
  }
  if (Status written = writePng(folder / "hills.png", picture); !written) return written.error();
  std::ofstream(folder / "hills.mtl") << "newmtl ground\nKd 1 1 1\nmap_Kd hills.png\n";
  std::ofstream obj(folder / "hills.obj");
  obj << "mtllib hills.mtl\no hills\nusemtl ground\n";
  for (int y = 0; y <= kHigh; ++y) {
    for (int x = 0; x <= kWide; ++x) {
      const double height = std::sin(x * 0.11) * std::cos(y * 0.13) * 0.6;
      obj << "v " << x * 0.1 - kWide * 0.05 << ' ' << y * 0.2 - kHigh * 0.1 << ' ' << height
          << "\nvt " << x / double{kWide} << ' ' << y / double{kHigh} << '\n';
    }
  }
  for (int y = 0; y < kHigh; ++y) {
    for (int x = 0; x < kWide; ++x) {
      const int a = y * (kWide + 1) + x + 1, b = a + 1, c = b + kWide + 1, d = c - 1;
      obj << "f " << a << '/' << a << ' ' << b << '/' << b << ' ' << c << '/' << c << '\n';
      obj << "f " << a << '/' << a << ' ' << c << '/' << c << ' ' << d << '/' << d << '\n';
    }
  }
  if (!obj.flush()) return Error{ErrorKind::refused, "cannot be written", folder.string()};
  return folder / "hills.obj";
}

Cell fieldOfLinks(std::size_t links) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(links)));
  std::vector<std::shared_ptr<const Mesh>> shapes;
  for (int i = 0; i < 16; ++i) {
    shapes.push_back(std::make_shared<const Mesh>(pyramid(0.4F + 0.05F * static_cast<float>(i))));
  }
  auto model = std::make_shared<Model>();
  model->name = "field";
  model->links.emplace_back().name = "ground";
  for (std::size_t i = 0; i < links; ++i) {
    Joint joint;
    joint.name = "slide" + std::to_string(i);
    joint.type = JointType::prismatic;
    joint.parent = 0;
    joint.child = model->links.size();
    joint.origin.position = {static_cast<double>(i % side), static_cast<double>(i / side), 0};
    joint.axis = {0, 0, 1};
    model->update_order.push_back(model->joints.size());
    model->joints.push_back(joint);
    Link link;
    link.name = "pyramid" + std::to_string(i);
    link.parent_joint = i;
    Visual visual;
    visual.mesh = shapes[i % shapes.size()];
    link.visuals.push_back(std::move(visual));
    model->links.push_back(std::move(link));
  }
  return cellOf(std::move(model));
}

SessionState fieldMoment(std::size_t links, int moment) {
  std::string text = "RK1 bench - -\njoints field";
  for (std::size_t i = 0; i < links; ++i) {
    const auto step = (i * 7 + static_cast<std::size_t>(moment) * 13) % 32;
    text += ' ' + std::to_string(0.01 * static_cast<double>(step));
  }
  SessionState state;
  const auto decoder = makeDecoder("rk1");
  if (const Packet* packet = decoder->decode(std::as_bytes(std::span(text)))) {
    state.apply(LogTime(), *packet);
  }
  return state;
}

Cell mergedField(const Cell& field, const SessionState& state) {
  const PosedScene scene = poseScene(field, state);
  const PosedDevice& device = scene.devices.front();
  Mesh merged;
  for (std::size_t link = 0; link < device.model->links.size(); ++link) {
    for (const Visual& visual : device.model->links[link].visuals) {
      const auto first = static_cast<std::uint32_t>(merged.vertices.size());
      for (const std::uint32_t index : visual.mesh->indices) {
        merged.indices.push_back(first + index);
      }
      for (Vertex vertex : visual.mesh->vertices) {
        const Vec3 at = transformPoint(device.link_world[link], Vec3(vertex.position));
        vertex.position = glm::vec3(at);
        merged.bounds.add(at);
        merged.vertices.push_back(vertex);
      }
    }
  }
  merged.parts = {{"all", 0, 0, static_cast<std::uint32_t>(merged.indices.size())}};
  merged.materials = {Material{}};
  auto model = std::make_shared<Model>();
  model->name = "merged";
  Link link;
  link.name = "all";
  Visual visual;
  visual.mesh = std::make_shared<const Mesh>(std::move(merged));
  link.visuals.push_back(std::move(visual));
  model->links.push_back(std::move(link));
  return cellOf(std::move(model));
}

}  // namespace rocinante::bench
