#include "viewer/detail/mesh_detail.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <unordered_map>

#include "core/base/hash.h"

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

/// Fewer triangles are not worth a separate draw call.
constexpr std::size_t kFewestTriangles = 64;
constexpr std::size_t kMaxVersions = 8;
/// Largest error relative to the part's size.
constexpr float kLargestError = 0.05F;
/// A version must be at most this share of the one before it.
constexpr double kWorthwhile = 0.8;

/// Some triangles with only the vertices that they use.
struct Patch {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> originals;  // of the mesh's vertices, by position
  std::vector<std::uint32_t> indices;
};

Patch cutOut(const Mesh& mesh, std::span<const std::uint32_t> indices) {
  Patch patch;
  std::unordered_map<std::uint32_t, std::uint32_t> numbers;
  numbers.reserve(indices.size() / 4);
  patch.indices.reserve(indices.size());
  for (const std::uint32_t index : indices) {
    const auto [known, fresh] =
        numbers.emplace(index, static_cast<std::uint32_t>(patch.originals.size()));
    if (fresh) {
      patch.originals.push_back(index);
      patch.positions.push_back(mesh.vertices[index].position);
    }
    patch.indices.push_back(known->second);
  }
  return patch;
}

struct Version {
  double error_m = 0;
  std::vector<std::uint32_t> indices;  // into the mesh's vertices
};

/// From fine to coarse; empty when nothing can be saved.
std::vector<Version> coarserVersions(const Mesh& mesh, std::span<const std::uint32_t> indices,
                                     bool lock_border) {
  std::vector<Version> versions;
  if (indices.size() / 3 < kFewestTriangles) return versions;
  const Patch patch = cutOut(mesh, indices);
  const float* const positions = &patch.positions.front().x;
  const std::size_t count = patch.positions.size();
  const double scale = meshopt_simplifyScale(positions, count, sizeof(glm::vec3));
  const unsigned options = lock_border ? unsigned{meshopt_SimplifyLockBorder} : 0U;

  std::vector<std::uint32_t> current = patch.indices;
  float error = 0;
  while (versions.size() < kMaxVersions && current.size() / 3 >= kFewestTriangles / 2) {
    std::vector<std::uint32_t> coarser(current.size());
    float added = 0;
    // Halve the triangles of the previous version; errors add up.
    const std::size_t size = meshopt_simplify(
        coarser.data(), current.data(), current.size(), positions, count, sizeof(glm::vec3),
        current.size() / 6 * 3, kLargestError - error, options, &added);
    coarser.resize(size);
    error += added;
    if (size == 0 || error > kLargestError ||
        static_cast<double>(size) > kWorthwhile * static_cast<double>(current.size())) {
      break;
    }
    meshopt_optimizeVertexCache(coarser.data(), coarser.data(), size, count);
    current = coarser;
    for (std::uint32_t& index : coarser) index = patch.originals[index];
    versions.push_back({static_cast<double>(error) * scale, std::move(coarser)});
  }
  return versions;
}

/// The coarsest version within the error; null: the part itself.
const Version* versionWithin(const std::vector<Version>& versions, double error_m) {
  const Version* best = nullptr;
  for (const Version& version : versions) {
    if (version.error_m <= error_m) best = &version;
  }
  return best;
}

void append(MeshDetail& detail, std::span<const std::uint32_t> indices) {
  detail.indices.insert(detail.indices.end(), indices.begin(), indices.end());
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

MeshDetail makeMeshDetail(const DetailInput& input) {
  const Mesh& mesh = *input.mesh;
  const std::span<const std::uint32_t> all(*input.indices);
  MeshDetail detail;
  detail.parts.resize(mesh.parts.size());
  const bool several = std::ranges::count_if(mesh.parts, [](const MeshPart& part) {
                         return part.index_count > 0;
                       }) > 1;
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    const MeshPart& part = mesh.parts[i];
    const std::uint32_t one_sided = input.one_sided_counts[i];
    const auto own = all.subspan(part.first_index, part.index_count);
    const auto both = own.first(part.index_count - one_sided);
    const auto front = own.last(one_sided);
    const bool lock = several || (!both.empty() && !front.empty());
    const std::vector<Version> of_both = coarserVersions(mesh, both, lock);
    const std::vector<Version> of_front = coarserVersions(mesh, front, lock);
    // Merge both lists: one entry per error at which either becomes coarser.
    std::vector<double> errors;
    for (const auto* versions : {&of_both, &of_front}) {
      for (const Version& version : *versions) errors.push_back(version.error_m);
    }
    std::ranges::sort(errors);
    errors.erase(std::unique(errors.begin(), errors.end()), errors.end());
    for (const double error : errors) {
      const Version* const both_version = versionWithin(of_both, error);
      const Version* const front_version = versionWithin(of_front, error);
      const auto both_indices = both_version != nullptr ? std::span(both_version->indices) : both;
      const auto front_indices =
          front_version != nullptr ? std::span(front_version->indices) : front;
      detail.parts[i].push_back({error, static_cast<std::uint32_t>(detail.indices.size()),
                                 static_cast<std::uint32_t>(both_indices.size()),
                                 static_cast<std::uint32_t>(front_indices.size())});
      append(detail, both_indices);
      append(detail, front_indices);
    }
  }
  return detail;
}

std::string detailKey(const DetailInput& input) {
  // Hash each array separately: they are large and not contiguous.
  Bytes all;
  const auto add = [&](ByteView bytes) {
    const auto hash = xxh3(bytes);
    all.insert(all.end(), hash.begin(), hash.end());
  };
  std::vector<std::uint32_t> runs;
  for (std::size_t i = 0; i < input.mesh->parts.size(); ++i) {
    const MeshPart& part = input.mesh->parts[i];
    runs.insert(runs.end(), {part.first_index, part.index_count, input.one_sided_counts[i]});
  }
  add(std::as_bytes(std::span(input.mesh->vertices)));
  add(std::as_bytes(std::span(*input.indices)));
  add(std::as_bytes(std::span(runs)));
  return hexOf(xxh3(all));
}

}  // namespace rocinante
