#include "viewer/detail/coarse_mesh.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "viewer/detail/mesh_detail.h"

namespace rocinante {
namespace {

/// Leaves out vertices that no triangle has, and keeps the order of the others.
void dropUnused(Mesh& mesh) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(mesh.vertices.size(), kUnused);
  for (const std::uint32_t index : mesh.indices) numbers[index] = 0;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == kUnused) continue;
    mesh.vertices[count] = mesh.vertices[i];
    if (!mesh.colors.empty()) mesh.colors[count] = mesh.colors[i];
    numbers[i] = count++;
  }
  mesh.vertices.resize(count);
  if (!mesh.colors.empty()) mesh.colors.resize(count);
  for (std::uint32_t& index : mesh.indices) index = numbers[index];
}

}  // namespace

Mesh coarseMesh(const Mesh& mesh, int halvings) {
  Mesh coarse = mesh;
  if (halvings < 1 || mesh.shape) return coarse;
  DetailInput input;
  input.mesh = &mesh;
  input.indices = &mesh.indices;
  input.one_sided_counts.assign(mesh.parts.size(), 0);
  const MeshDetail detail = makeMeshDetail(input);
  coarse.indices.clear();
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    MeshPart& part = coarse.parts[i];
    std::span<const std::uint32_t> kept =
        std::span(mesh.indices).subspan(part.first_index, part.index_count);
    if (const auto& versions = detail.parts[i]; !versions.empty()) {
      const std::size_t wanted = std::min(versions.size(), static_cast<std::size_t>(halvings)) - 1;
      kept = std::span(detail.indices)
                 .subspan(versions[wanted].first_index, versions[wanted].two_sided_count);
    }
    part.first_index = static_cast<std::uint32_t>(coarse.indices.size());
    part.index_count = static_cast<std::uint32_t>(kept.size());
    coarse.indices.insert(coarse.indices.end(), kept.begin(), kept.end());
  }
  dropUnused(coarse);
  return coarse;
}

}  // namespace rocinante
