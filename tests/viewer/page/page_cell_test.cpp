#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>

#include "core/bundle/baked_file.h"
#include "viewer/bake/bake_cell.h"
#include "viewer/page/page_parts.h"

namespace rocinante {
namespace {

std::shared_ptr<const Model> modelIn(const std::string& folder) {
  Mesh mesh;
  mesh.vertices = {{{0, 0, 0}, {0, 0, 1}, {0, 0}},
                   {{1, 0, 0}, {0, 0, 1}, {1, 0}},
                   {{0, 1, 0}, {0, 0, 1}, {0, 1}}};
  mesh.indices = {0, 1, 2};
  mesh.parts = {{"front", 0, 0, 3}, {"back", 1, 0, 3}};
  mesh.materials.resize(2);
  mesh.materials[0].diffuse_map = folder + "/brick/wall.png";
  mesh.materials[1].diffuse_map = folder + "/steel/wall.png";
  for (const Vertex& vertex : mesh.vertices) mesh.bounds.add(Vec3(vertex.position));
  auto model = std::make_shared<Model>();
  model->name = "hall";
  model->file = folder + "/hall.urdf";
  model->links.resize(1);
  model->links[0].name = "hall";
  model->links[0].visuals.resize(1);
  model->links[0].visuals[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  model->update_order = {};
  model->link_by_name = {{"hall", 0}};
  return model;
}

Cell cellIn(const std::string& folder) {
  Cell cell;
  cell.file = folder + "/hall.cell.toml";
  cell.files = {folder + "/hall.cell.toml", folder + "/hall.urdf"};
  cell.models["hall.urdf"] = modelIn(folder);
  CellDevice hall;
  hall.name = "hall";
  hall.model = "hall.urdf";
  cell.devices = {hall};
  cell.device_by_name = {{"hall", 0}};
  return cell;
}

TEST(PageCell, IsTheSameWhereverTheCellLies) {
  EXPECT_EQ(pageCell(cellIn("/home/ada/secret"), {}, {}), pageCell(cellIn("/srv/other"), {}, {}));
}

TEST(PageCell, GivesNoFolderAway) {
  const Bytes baked = pageCell(cellIn("/home/ada/secret"), {}, {});
  const std::string_view text = textOf(baked);
  EXPECT_EQ(text.find("secret"), std::string_view::npos);
  EXPECT_NE(text.find("hall.cell.toml"), std::string_view::npos);
}

TEST(PageCell, PicturesOfOneNameStayTwo) {
  const auto bytes = std::make_shared<const Bytes>(pageCell(cellIn("/home/ada"), {}, {}));
  const auto file = BakedFile::parse(*bytes, "test");
  ASSERT_TRUE(file.has_value());
  const auto cell = readBakedCell(*file, bytes);
  ASSERT_TRUE(cell.has_value()) << cell.error().text();
  const auto& materials = cell->models.at("hall.urdf")->links[0].visuals[0].mesh->materials;
  EXPECT_NE(materials[0].diffuse_map, materials[1].diffuse_map);
  EXPECT_EQ(materials[0].diffuse_map.filename(), "wall.png");
}

TEST(PageCell, CollisionGeometryIsNoPartOfAPage) {
  Cell cell = cellIn("/home/ada");
  auto model = std::make_shared<Model>(*cell.models.at("hall.urdf"));
  model->links[0].collisions = model->links[0].visuals;
  const Bytes without = pageCell(cell, {}, {});
  cell.models["hall.urdf"] = model;
  EXPECT_EQ(pageCell(cell, {}, {}), without);
}

}  // namespace
}  // namespace rocinante
