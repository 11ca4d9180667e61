#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/mesh/mesh_builder.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/polygon.h"
#include "core/mesh/position_index.h"
#include "core/mesh/text_scanner.h"

namespace rocinante {
namespace {

constexpr std::size_t kHeaderBytes = 84;  // 80 of comment, 4 of count
constexpr std::size_t kLongestStlWord = 16;
constexpr std::size_t kFacetBytes = 50;  // normal, three points: 12 floats; 2 of attributes

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
    const std::string_view text = textOf(bytes_);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
      return Error{ErrorKind::unsupported, "is UTF-16 text; save it as UTF-8", path_.string()};
    }
    if (isBinary()) {
      readBinary();
    } else {
      readAscii();
    }
    if (loose_.corners.empty()) {
      return Error{ErrorKind::damaged, "holds no triangle that can be drawn", path_.string()};
    }
    if (opposed_ > 0) {
      faults_.leaveOut("value", "normal", first_opposed_,
                       "the order of the corners decides which side is outside, and these normals "
                       "point to the other",
                       Severity::warning, "model.left-out", {}, opposed_);
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
    // A binary file of the wrong length may begin with "solid" too; text has no zero bytes, which
    // every count of a binary file has.
    return bytes_.empty() || text.substr(0, 1024).find('\0') != std::string_view::npos;
  }

  void readBinary() {
    if (bytes_.size() < kHeaderBytes) {
      faults_.add(Severity::error, "stl.truncated", {},
                  fmt::format("{} bytes are less than an STL header", bytes_.size()));
      return;
    }
    const std::uint64_t claimed = countOfHeader();
    const std::uint64_t held = (bytes_.size() - kHeaderBytes) / kFacetBytes;
    std::uint64_t count = std::min(claimed, held);
    if (claimed > held) {
      faults_.add(Severity::error, "stl.truncated", {},
                  fmt::format("the header says {} triangles, the file holds {}", claimed, held));
    } else if (claimed == 0 && held > 0) {
      // Written before its count was known.
      count = held;
      faults_.add(Severity::warning, "stl.trailing-bytes", {},
                  fmt::format("the header says 0 triangles; the {} that follow are read", held));
    } else if (bytes_.size() - kHeaderBytes != claimed * kFacetBytes) {
      faults_.add(Severity::warning, "stl.trailing-bytes", {},
                  fmt::format("{} bytes follow the {} triangles of the header",
                              bytes_.size() - kHeaderBytes - claimed * kFacetBytes, claimed));
    }
    loose_.corners.reserve(count * 3);
    for (std::uint64_t i = 0; i < count; ++i) {
      std::array<float, 12> numbers;
      std::memcpy(numbers.data(), bytes_.data() + kHeaderBytes + i * kFacetBytes, 48);
      std::array<Vec3, 3> facet;
      for (std::size_t c = 0; c < 3; ++c) {
        facet[c] = {numbers[3 + c * 3], numbers[4 + c * 3], numbers[5 + c * 3]};
      }
      const std::byte* const attribute = bytes_.data() + kHeaderBytes + i * kFacetBytes + 48;
      if (attribute[0] != std::byte{0} || attribute[1] != std::byte{0}) ++attributes_;
      compareNormal({numbers[0], numbers[1], numbers[2]}, facet, 0);
      addFacet(facet, 0, i);
    }
    if (attributes_ > 0) {
      faults_.leaveOut(
          "value", "attribute bytes", {},
          "colours of triangles, which programs write in different ways, are not drawn",
          Severity::note, "model.left-out", {}, attributes_);
    }
    if (textOf(bytes_).substr(0, kHeaderBytes - 4).find("COLOR=") != std::string_view::npos) {
      faults_.leaveOut("value", "COLOR=", {}, "the colour in the header is not drawn");
    }
  }

  void readAscii() {
    TextScanner scan(textOf(bytes_));
    std::array<Vec3, 3> facet;
    std::size_t corners = 0;
    std::uint64_t number = 0, solids = 0;
    Vec3 normal(0.0);
    int normal_line = 0, last_line = 0;
    bool is_ended = true;
    for (; !scan.atEnd(); scan.skipLine()) {
      if (!scan.skipBlanks()) continue;
      const int line = scan.line();
      const std::string_view given = scan.word();
      std::string word(given.substr(0, kLongestStlWord));
      std::ranges::transform(word, word.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      });
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
          compareNormal(normal, facet, normal_line);
          addFacet(facet, line, number);
        } else if (corners < facet.size()) {
          faults_.add(Severity::error, "stl.bad-facet", {line},
                      fmt::format("a facet of {} corners", corners));
        }
        corners = 0;
        ++number;
        normal = Vec3(0.0);
      } else if (word == "facet") {
        scan.skipBlanks();
        scan.word();
        if (!scan.number(normal.x) || !scan.number(normal.y) || !scan.number(normal.z)) {
          normal = Vec3(0.0);
        }
        normal_line = line;
      } else if (word == "solid") {
        if (++solids == 2) {
          faults_.leaveOut("statement", "solid", {line}, "all solids of a file become one part");
        }
      } else if (word != "outer" && word != "endloop" && word != "endsolid") {
        faults_.leaveOut("statement", given, {line}, "it is unknown in STL", Severity::warning,
                         "stl.unknown-keyword");
        continue;
      }
      is_ended = word == "endsolid";
      last_line = line;
    }
    if (corners > 0) {
      faults_.add(Severity::error, "stl.truncated", {scan.line()}, "ends inside a facet");
    } else if (!is_ended) {
      faults_.add(Severity::warning, "stl.truncated", {last_line},
                  "ends without `endsolid`: perhaps not all of it is there");
    }
  }

  /// The order of a facet's corners says which side is outside; its normal may say the opposite.
  void compareNormal(const Vec3& normal, const std::array<Vec3, 3>& facet, int line) {
    const Vec3 wound = crossOf(facet[1] - facet[0], facet[2] - facet[0]);
    // Slanted by more than 120 degrees: not what rounding does to a sliver.
    if (!(dotOf(normal, wound) < -0.5 * lengthOf(normal) * lengthOf(wound))) return;
    if (opposed_++ == 0) first_opposed_ = {line};
  }

  void addFacet(const std::array<Vec3, 3>& facet, int line, std::uint64_t number) {
    std::array<glm::vec3, 3> points;
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& p = facet[c];
      const Vec3 up = options_.up == UpAxis::y ? Vec3(p.x, -p.z, p.y) : p;
      points[c] = glm::vec3(up * options_.unit_m);
      if (!isDrawablePoint(points[c])) {
        faults_.add(Severity::error, "stl.bad-number", {line},
                    fmt::format("triangle {} has a corner that {}", number,
                                std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)
                                    ? "is too far away to be drawn"
                                    : "is not a number"));
        return;
      }
    }
    for (const glm::vec3& point : points) loose_.corners.push_back({points_.numberOf(point)});
  }

  ByteView bytes_;
  const std::filesystem::path& path_;
  const MeshReadOptions& options_;
  FaultList& faults_;
  std::uint64_t attributes_ = 0, opposed_ = 0;  ///< triangles that have such
  Place first_opposed_;
  PositionIndex points_;
  LooseMesh loose_;
};

}  // namespace

Result<Mesh> readStl(ByteView bytes, const std::filesystem::path& path,
                     const MeshReadOptions& options, FaultList& faults) {
  return StlReader(bytes, path, options, faults).read();
}

}  // namespace rocinante
