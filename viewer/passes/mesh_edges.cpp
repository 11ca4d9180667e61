#include "viewer/passes/mesh_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "core/mesh/position_index.h"

namespace rocinante {
namespace {

constexpr float kCreaseCosine = 0.8660254F;  // 30 degrees
constexpr float kFlatCosine = 0.99985F;      // one degree

/// A triangle's side, with its corners sorted by number.
struct Side {
  std::uint32_t group, low, high;
  std::uint32_t triangle;
  bool forward;  ///< the triangle runs from low to high

  bool sameEdge(const Side& other) const {
    return group == other.group && low == other.low && high == other.high;
  }
};

enum class EdgeKind : std::uint8_t { feature, flat };

struct FoundEdge {
  std::uint32_t part;
  EdgeKind kind;
  std::array<std::uint32_t, 2> triangles;
  MeshEdge edge;
};

/// Triangles connected by smooth edges; sums in double.
struct Face {
  double area = 0, border = 0;
  std::array<double, 3> moment{};
  std::array<double, 6> second{};  // xx, yy, zz, xy, yz, zx

  void add(const std::array<glm::dvec3, 3>& corners) {
    const glm::dvec3 u = corners[1] - corners[0];
    const glm::dvec3 v = corners[2] - corners[0];
    const glm::dvec3 n(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    const double part = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z) / 2;
    const glm::dvec3 sum = corners[0] + corners[1] + corners[2];
    area += part;
    for (int i = 0; i < 3; ++i) {
      const int k = (i + 1) % 3;
      double square = sum[i] * sum[i];
      double product = sum[i] * sum[k];
      for (const glm::dvec3& corner : corners) {
        square += corner[i] * corner[i];
        product += corner[i] * corner[k];
      }
      const auto at = static_cast<std::size_t>(i);
      moment[at] += part / 3 * sum[i];
      second[at] += part / 12 * square;
      second[at + 3] += part / 12 * product;
    }
  }

  /// The smaller of two estimates: area divided by border, right for flat faces and rings; and the
  /// spread of the area across its length, right for closed tubes.
  float width() const {
    if (!(area > 0)) return 0;
    std::array<double, 6> spread{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3;
      spread[i] = second[i] / area - moment[i] / area * (moment[i] / area);
      spread[i + 3] = second[i + 3] / area - moment[i] / area * (moment[k] / area);
    }
    double minors = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      minors += spread[i] * spread[(i + 1) % 3] - spread[i + 3] * spread[i + 3];
    }
    const double trace = spread[0] + spread[1] + spread[2];
    const double across = trace > 0 && minors > 0 ? 2 * std::sqrt(minors / trace) : 0;
    return static_cast<float>(border > 0 ? std::min(2 * area / border, across) : across);
  }
};

class EdgeFinder {
 public:
  explicit EdgeFinder(const Mesh& mesh) : mesh_(mesh), corners_(mesh.vertices.size()) {}

  MeshEdges find() {
    collectTriangles();
    collectSides();
    for (std::size_t begin = 0; begin < sides_.size();) {
      std::size_t end = begin + 1;
      while (end < sides_.size() && sides_[end].sameEdge(sides_[begin])) ++end;
      addEdge(begin, end);
      begin = end;
    }
    measureFaces();
    return sorted();
  }

 private:
  struct Triangle {
    std::array<std::uint32_t, 3> corners{};
    std::uint32_t part = 0, group = 0;
    glm::vec3 normal{};
  };

  void collectTriangles() {
    std::map<std::string, std::uint32_t, std::less<>> groups;
    for (std::uint32_t p = 0; p < mesh_.parts.size(); ++p) {
      const MeshPart& part = mesh_.parts[p];
      const auto group =
          groups.emplace(part.group, static_cast<std::uint32_t>(groups.size())).first->second;
      for (std::uint32_t i = 0; i + 2 < part.index_count; i += 3) {
        Triangle triangle;
        triangle.part = p;
        triangle.group = group;
        for (std::uint32_t k = 0; k < 3; ++k) {
          const std::uint32_t index = mesh_.indices[part.first_index + i + k];
          triangle.corners[k] = corners_.numberOf(mesh_.vertices[index].position);
        }
        const auto& [a, b, c] = triangle.corners;
        if (a == b || b == c || c == a) continue;
        const glm::vec3& at = corners_.positions()[a];
        const glm::vec3 u = corners_.positions()[b] - at;
        const glm::vec3 v = corners_.positions()[c] - at;
        const glm::vec3 n(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
        const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
        // A degenerate triangle has no normal: its neighbours meet at it as at a crease.
        triangle.normal = length > 0 ? n * (1 / length) : glm::vec3(0);
        triangles_.push_back(triangle);
      }
    }
    dropSecondSides();
  }

  /// Keeps the first of triangles with the same three corners.
  void dropSecondSides() {
    const auto key = [](const Triangle& triangle) {
      std::array<std::uint32_t, 3> corners = triangle.corners;
      std::sort(corners.begin(), corners.end());
      return std::pair(triangle.group, corners);
    };
    std::vector<std::uint32_t> order(triangles_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return key(triangles_[a]) < key(triangles_[b]);
    });
    std::vector<bool> second(triangles_.size(), false);
    for (std::size_t i = 1; i < order.size(); ++i) {
      second[order[i]] = key(triangles_[order[i]]) == key(triangles_[order[i - 1]]);
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      if (!second[i]) triangles_[kept++] = triangles_[i];
    }
    triangles_.resize(kept);
  }

  void collectSides() {
    sides_.reserve(triangles_.size() * 3);
    joined_.resize(triangles_.size());
    for (std::uint32_t t = 0; t < joined_.size(); ++t) joined_[t] = t;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& triangle = triangles_[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = triangle.corners[k];
        const std::uint32_t to = triangle.corners[(k + 1) % 3];
        sides_.push_back({triangle.group, std::min(from, to), std::max(from, to), t, from < to});
      }
    }
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
      return std::tie(a.group, a.low, a.high, a.triangle) <
             std::tie(b.group, b.low, b.high, b.triangle);
    });
  }

  void addEdge(std::size_t begin, std::size_t end) {
    const Side& first = sides_[begin];
    FoundEdge found;
    found.part = triangles_[first.triangle].part;
    found.kind = EdgeKind::feature;
    found.triangles = {first.triangle, sides_[end - 1].triangle};
    found.edge.a = corners_.positions()[first.low];
    found.edge.b = corners_.positions()[first.high];
    if (end - begin == 2) {
      const glm::vec3& one = triangles_[first.triangle].normal;
      glm::vec3 other = triangles_[sides_[begin + 1].triangle].normal;
      // Neighbours that are wound the same way run along their common side in opposite directions.
      if (sides_[begin + 1].forward == first.forward) other = -other;
      const float cosine = one.x * other.x + one.y * other.y + one.z * other.z;
      if (cosine > kFlatCosine) {
        found.kind = EdgeKind::flat;
      } else if (cosine > kCreaseCosine) {
        found.edge.first_normal = one;
        found.edge.second_normal = other;
      }
      if (cosine > kCreaseCosine) joined_[faceOf(found.triangles[0])] = faceOf(found.triangles[1]);
    }
    found_.push_back(found);
  }

  /// The representative triangle of its face.
  std::uint32_t faceOf(std::uint32_t triangle) {
    while (joined_[triangle] != triangle) {
      joined_[triangle] = joined_[joined_[triangle]];
      triangle = joined_[triangle];
    }
    return triangle;
  }

  void measureFaces() {
    std::vector<std::uint32_t> number(triangles_.size(), 0);
    std::vector<Face> faces;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const std::uint32_t stands = faceOf(t);
      if (number[stands] == 0) {
        faces.emplace_back();
        number[stands] = static_cast<std::uint32_t>(faces.size());
      }
      // Relative to one of its corners: squares of large coordinates would lose small faces.
      const glm::dvec3 origin(corners_.positions()[triangles_[stands].corners[0]]);
      std::array<glm::dvec3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = glm::dvec3(corners_.positions()[triangles_[t].corners[k]]) - origin;
      }
      faces[number[stands] - 1].add(corners);
    }
    const auto face = [&](std::uint32_t t) -> Face& { return faces[number[faceOf(t)] - 1]; };
    for (const FoundEdge& found : found_) {
      const glm::dvec3 way = glm::dvec3(found.edge.b) - glm::dvec3(found.edge.a);
      const auto& [one, other] = found.triangles;
      if (one != other && faceOf(one) == faceOf(other)) continue;
      const double length = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
      face(one).border += length;
      if (one != other) face(other).border += length;
    }
    for (FoundEdge& found : found_) {
      const auto& [one, other] = found.triangles;
      found.edge.face_width = std::max(face(one).width(), face(other).width());
    }
  }

  MeshEdges sorted() {
    std::stable_sort(found_.begin(), found_.end(), [](const FoundEdge& a, const FoundEdge& b) {
      return std::tie(a.part, a.kind) < std::tie(b.part, b.kind);
    });
    MeshEdges edges;
    edges.parts.resize(mesh_.parts.size());
    edges.edges.reserve(found_.size());
    for (const FoundEdge& found : found_) {
      PartEdges& part = edges.parts[found.part];
      if (part.all == 0) part.first = static_cast<std::uint32_t>(edges.edges.size());
      part.all += 1;
      if (found.kind == EdgeKind::feature) part.features += 1;
      edges.edges.push_back(found.edge);
    }
    return edges;
  }

  const Mesh& mesh_;
  PositionIndex corners_;
  std::vector<Triangle> triangles_;
  std::vector<Side> sides_;
  std::vector<FoundEdge> found_;
  std::vector<std::uint32_t> joined_;  // by triangle: towards its face's representative
};

}  // namespace

MeshEdges meshEdges(const Mesh& mesh) { return EdgeFinder(mesh).find(); }

}  // namespace rocinante
