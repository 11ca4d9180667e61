#include "core/mesh/stl_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/mesh/mesh_builder.h"
#include "core/mesh/position_index.h"
#include "core/mesh/smooth_normals.h"
#include "core/mesh/text_scanner.h"

namespace rocinante {
namespace {

constexpr std::size_t kHeaderBytes = 84;  // 80 of comment, 4 of count
constexpr std::size_t kFacetBytes = 50;   // normal, three points: 12 floats; 2 of attributes

// The format is little-endian, and so is every machine that we run on.
static_assert(std::endian::native == std::endian::little);

class StlReader {
 public:
  StlReader(ByteView bytes, const std::filesystem::path& path, const MeshReadOptions& options,
            FaultList& faults)
      : bytes_(bytes),
        path_(path),
        options_(options),
        faults_(faults),
        points_(bytes.size() / 100) {}

  Result<Mesh> read() {
    if (isBinary()) {
      readBinary();
    } else {
      readAscii();
    }
    if (loose_.corners.empty()) {
      return Error{ErrorKind::damaged, "holds no triangle that can be drawn", path_.string()};
    }
    loose_.positions = points_.takePositions();
    loose_.materials.emplace_back();
    loose_.parts.push_back({"", 0, 0, static_cast<std::uint32_t>(loose_.corners.size())});
    smoothNormals(loose_, options_.smooth_angle_deg);
    return indexedMesh(std::move(loose_));
  }

 private:
  std::uint32_t countOfHeader() const {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes_.data() + kHeaderBytes - 4, 4);
    return count;
  }

  bool isBinary() const {
    const std::string_view text = textOf(bytes_);
    if (bytes_.size() >= kHeaderBytes &&
        bytes_.size() == kHeaderBytes + std::uint64_t{countOfHeader()} * kFacetBytes) {
      return true;
    }
    TextScanner scan(text);
    scan.skipBlanks();
    if (scan.word() != "solid") return true;
    // A binary file of the wrong length may also begin with "solid"; text has no zero bytes.
    return text.substr(0, 1024).find('\0') != std::string_view::npos;
  }

  void readBinary() {
    if (bytes_.size() < kHeaderBytes) {
      faults_.add(Severity::error, "stl.truncated", {},
                  fmt::format("{} bytes are less than an STL header", bytes_.size()));
      return;
    }
    const std::uint64_t claimed = countOfHeader();
    const std::uint64_t held = (bytes_.size() - kHeaderBytes) / kFacetBytes;
    if (claimed > held) {
      faults_.add(Severity::error, "stl.truncated", {},
                  fmt::format("the header says {} triangles, the file holds {}", claimed, held));
    } else if (bytes_.size() - kHeaderBytes != claimed * kFacetBytes) {
      faults_.add(Severity::warning, "stl.trailing-bytes", {},
                  fmt::format("{} bytes follow the {} triangles of the header",
                              bytes_.size() - kHeaderBytes - claimed * kFacetBytes, claimed));
    }
    const std::uint64_t count = std::min(claimed, held);
    loose_.corners.reserve(count * 3);
    for (std::uint64_t i = 0; i < count; ++i) {
      std::array<float, 12> numbers;
      std::memcpy(numbers.data(), bytes_.data() + kHeaderBytes + i * kFacetBytes, 48);
      std::array<Vec3, 3> facet;
      for (std::size_t c = 0; c < 3; ++c) {
        facet[c] = {numbers[3 + c * 3], numbers[4 + c * 3], numbers[5 + c * 3]};
      }
      addFacet(facet, 0, i);
    }
  }

  void readAscii() {
    TextScanner scan(textOf(bytes_));
    std::array<Vec3, 3> facet;
    std::size_t corners = 0;
    std::uint64_t number = 0;
    for (; !scan.atEnd(); scan.skipLine()) {
      if (!scan.skipBlanks()) continue;
      const int line = scan.line();
      const std::string_view word = scan.word();
      if (word == "vertex") {
        Vec3 p(0.0);
        if (!scan.number(p.x) || !scan.number(p.y) || !scan.number(p.z)) {
          scan.skipBlanks();
          faults_.add(Severity::error, "stl.bad-number", {line},
                      "vertex needs three numbers, not " + quotedInFault(scan.word()));
          // Too many corners: the facet is left out; its fault was just reported.
          corners = facet.size() + 1;
        } else if (corners < facet.size()) {
          facet[corners++] = p;
        } else if (corners == facet.size()) {
          faults_.add(Severity::error, "stl.bad-facet", {line},
                      "a facet of more than three corners");
          ++corners;
        }
      } else if (word == "endfacet") {
        if (corners == facet.size()) {
          addFacet(facet, line, number);
        } else if (corners < facet.size()) {
          faults_.add(Severity::error, "stl.bad-facet", {line},
                      fmt::format("a facet of {} corners", corners));
        }
        corners = 0;
        ++number;
      } else if (word != "facet" && word != "outer" && word != "endloop" && word != "solid" &&
                 word != "endsolid") {
        faults_.add(Severity::warning, "stl.unknown-keyword", {line},
                    quotedInFault(word) + " is unknown in STL");
      }
    }
    if (corners > 0) {
      faults_.add(Severity::error, "stl.truncated", {scan.line()}, "ends inside a facet");
    }
  }

  void addFacet(const std::array<Vec3, 3>& facet, int line, std::uint64_t number) {
    std::array<glm::vec3, 3> points;
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& p = facet[c];
      const Vec3 up = options_.up == UpAxis::y ? Vec3(p.x, -p.z, p.y) : p;
      points[c] = glm::vec3(up * options_.unit_m);
      if (!std::isfinite(points[c].x) || !std::isfinite(points[c].y) ||
          !std::isfinite(points[c].z)) {
        faults_.add(Severity::error, "stl.bad-number", {line},
                    fmt::format("triangle {} has a corner that is not a number", number));
        return;
      }
    }
    for (const glm::vec3& point : points) loose_.corners.push_back({points_.numberOf(point)});
  }

  ByteView bytes_;
  const std::filesystem::path& path_;
  const MeshReadOptions& options_;
  FaultList& faults_;
  PositionIndex points_;
  LooseMesh loose_;
};

}  // namespace

Result<Mesh> readStl(ByteView bytes, const std::filesystem::path& path,
                     const MeshReadOptions& options, FaultList& faults) {
  return StlReader(bytes, path, options, faults).read();
}

}  // namespace rocinante
