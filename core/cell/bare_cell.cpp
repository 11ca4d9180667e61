#include "core/cell/bare_cell.h"

#include "core/mesh/shapes.h"

namespace rocinante {

Cell bareCell() {
  constexpr double kSide = 0.02;
  Visual cube;
  cube.name = "cube";
  cube.mesh = std::make_shared<const Mesh>(boxMesh(Vec3(kSide, kSide, kSide)));
  Link link;
  link.name = "frame";
  link.visuals.push_back(std::move(cube));
  auto model = std::make_shared<Model>();
  model->name = "frame";
  model->links.push_back(std::move(link));
  Cell cell;
  // No packet names it so: a name has no space.
  cell.bare_model = "a frame";
  cell.models[cell.bare_model] = std::move(model);
  return cell;
}

}  // namespace rocinante
