#pragma once

#include "core/math/vector.h"
#include "core/mesh/mesh.h"

namespace rocinante {

/// Shapes of URDF, centred on the origin: sizes in metres, axis along z. Deterministic vertices.
/// A capsule's length is that of its cylinder, without the two half spheres.
Mesh boxMesh(const Vec3& size);
Mesh cylinderMesh(double radius, double length);
Mesh sphereMesh(double radius);
Mesh capsuleMesh(double radius, double length);

}  // namespace rocinante
