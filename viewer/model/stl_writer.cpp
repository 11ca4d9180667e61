#include <array>
#include <bit>

#include "core/math/transform.h"
#include "viewer/model/model_writers.h"

namespace rocinante {
namespace {

constexpr std::size_t kHeaderBytes = 80;

void addNumber(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(static_cast<unsigned char>(number >> shift & 0xFFU));
  }
}

void addPoint(std::string& bytes, const Vec3& point) {
  for (const double value : {point.x, point.y, point.z}) {
    addNumber(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value) + 0.0F));
  }
}

// By the right-hand rule; zero for a triangle without area.
Vec3 normalOf(const std::array<Vec3, 3>& p) {
  return normalized(crossOf(p[1] - p[0], p[2] - p[0])).value_or(Vec3{0, 0, 0});
}

}  // namespace

StlWriter::StlWriter() : bytes_("binary STL, metres, z up") {
  // Not "solid", which marks the text format.
  bytes_.resize(kHeaderBytes, ' ');
  addNumber(bytes_, 0);
}

void StlWriter::add(const PosedPart& part) {
  const MeshPart& run = *part.part;
  for (std::uint32_t i = 0; i + 2 < run.index_count; i += 3) {
    std::array<Vec3, 3> points;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t index = part.mesh->indices[run.first_index + i + k];
      points[k] = worldPoint(part, part.mesh->vertices[index].position);
    }
    if (part.mirrored) std::swap(points[1], points[2]);
    addPoint(bytes_, normalOf(points));
    for (const Vec3& point : points) addPoint(bytes_, point);
    bytes_.append(2, '\0');
    ++triangles_;
  }
}

std::string StlWriter::finish() {
  std::string count;
  addNumber(count, static_cast<std::uint32_t>(triangles_));
  bytes_.replace(kHeaderBytes, count.size(), count);
  return std::move(bytes_);
}

}  // namespace rocinante
