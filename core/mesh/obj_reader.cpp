#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_builder.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/mtl_reader.h"
#include "core/mesh/obj_materials.h"
#include "core/mesh/polygon.h"
#include "core/mesh/text_scanner.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// Vertices and corners are numbered with 32 bits; half of that leaves room for the arithmetic.
constexpr std::size_t kMaxElements = std::size_t{1} << 31U;
constexpr std::uint32_t kWhite = 0xFFFFFFFF;

class ObjReader {
 public:
  ObjReader(ByteView bytes, const fs::path& path, const MeshReadOptions& options, FaultList& faults)
      : scan_(textOf(bytes)),
        path_(path),
        options_(options),
        faults_(faults),
        materials_(path, resolverOf(options), faults) {
    // Typical counts for a file of that size; untouched memory costs nothing.
    loose_.positions.reserve(bytes.size() / 70);
    loose_.corners.reserve(bytes.size() / 24);
  }

  Result<Mesh> read() {
    for (; !scan_.atEnd(); scan_.skipLine()) {
      if (!scan_.skipBlanks()) continue;
      line_ = scan_.line();
      readStatement(scan_.word());
    }
    closePart();
    if (loose_.corners.empty()) {
      return Error{ErrorKind::damaged, "holds no face that can be drawn", path_.string()};
    }
    if (first_without_vt_ > 0) {
      faults_.leaveOut("index", "vt", {first_without_vt_},
                       "faces name what the file has no `vt` for");
    }
    if (first_without_vn_ > 0) {
      faults_.leaveOut("index", "vn", {first_without_vn_},
                       "faces name what the file has no `vn` for");
    }
    loose_.materials = materials_.takeAll(!loose_.colors.empty());
    smoothNormals(loose_, options_.smooth_angle_deg);
    return indexedMesh(std::move(loose_));
  }

 private:
  void readStatement(std::string_view keyword) {
    // Nearly every line is one of these; comparing strings would be slow.
    const char first = keyword.empty() ? '\0' : keyword[0];
    const char second = keyword.size() == 2 ? keyword[1] : '\0';
    if (keyword.size() == 1 && first == 'v') return readPosition();
    if (keyword.size() == 1 && first == 'f') return readFace();
    if (first == 'v' && second == 'n') return readNormal();
    if (first == 'v' && second == 't') return readTexture();
    readRareStatement(keyword);
  }

  void readRareStatement(std::string_view keyword) {
    if (keyword == "fo") {
      readFace();
    } else if (keyword == "usemtl") {
      useMaterial(scan_.restOfLine());
    } else if (keyword == "g") {
      setGroup(scan_.restOfLine());
    } else if (keyword == "o") {
      object_ = scan_.restOfLine();
      setGroup("");
    } else if (keyword == "mtllib") {
      materials_.readLibraries(scan_.restOfLine(), line_);
    } else if (keyword == "s") {
      setSmoothing();
    } else if (!keyword.starts_with('#')) {
      passOver(keyword);
    }
  }

  /// The file's unit and up axis applied.
  glm::vec3 inMetres(const Vec3& p) const {
    const Vec3 up = turned(p);
    return {static_cast<float>(up.x * options_.unit_m), static_cast<float>(up.y * options_.unit_m),
            static_cast<float>(up.z * options_.unit_m)};
  }
  Vec3 turned(const Vec3& p) const { return options_.up == UpAxis::y ? Vec3(p.x, -p.z, p.y) : p; }

  void readPosition() {
    Vec3 p(0.0);
    const bool whole = readNumbers("v", p.x, p.y, p.z);
    if (!whole) p.x = NAN;
    glm::vec3 position = inMetres(p);
    if (!isDrawablePoint(position)) {
      if (!std::isnan(p.x)) {
        add(Severity::error, "obj.bad-number", "v is outside the range that can be drawn");
      }
      // The point keeps its index, so that later faces stay right.
      position.x = NAN;
    }
    loose_.positions.push_back(position);
    if (whole && scan_.skipBlanks()) readColor();
    if (!loose_.colors.empty()) loose_.colors.resize(loose_.positions.size(), kWhite);
  }

  /// Behind a position: a weight, or red, green and blue.
  void readColor() {
    double numbers[3] = {0, 0, 0};
    if (scan_.take('#')) return;  // a comment
    if (!scan_.number(numbers[0]))
      return leaveOut("value", "v", "it is not a number behind a point");
    if (!scan_.number(numbers[1])) {
      if (numbers[0] != 1) leaveOut("value", "weight of v", "points have no weight");
      return;
    }
    if (!scan_.number(numbers[2])) {
      return leaveOut("value", "v", "two numbers behind a point are neither weight nor colour");
    }
    const glm::vec4 color(numbers[0], numbers[1], numbers[2], 1.0);
    for (const double component : numbers) {
      if (component >= 0 && component <= 1) continue;
      add(Severity::warning, "obj.color-range", "a colour of v is outside 0 to 1 and is clamped");
      break;
    }
    loose_.colors.resize(loose_.positions.size(), kWhite);
    loose_.colors.back() = packedColor(color);
  }

  void readNormal() {
    Vec3 n(0.0);
    if (!readNumbers("vn", n.x, n.y, n.z)) n = Vec3(0.0);
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    // A normal of length zero, or too long to normalise, is computed like a missing one.
    const bool sound = length > 0 && std::isfinite(length);
    loose_.normals.push_back(sound ? glm::vec3(turned(n / length)) : glm::vec3(NAN));
  }

  void readTexture() {
    double u = 0, v = 0;
    if (!scan_.number(u)) {
      badNumber("vt");
    } else if (scan_.skipBlanks() && !scan_.number(v)) {
      badNumber("vt");
    }
    double w = 0;
    if (scan_.skipBlanks() && scan_.number(w) && w != 0) {
      leaveOut("value", "third number of vt", "images have two dimensions");
    }
    const auto in_range = [](double value) {
      const auto narrow = static_cast<float>(value);
      return std::isfinite(narrow) ? narrow : 0.0F;
    };
    loose_.textures.emplace_back(in_range(u), in_range(v));
  }

  bool readNumbers(std::string_view keyword, double& x, double& y, double& z) {
    if (scan_.number(x) && scan_.number(y) && scan_.number(z)) return true;
    badNumber(keyword);
    return false;
  }

  void badNumber(std::string_view keyword) {
    scan_.skipBlanks();
    add(Severity::error, "obj.bad-number",
        fmt::format("{} needs a number, not {}", keyword, quotedInFault(scan_.word())));
  }

  void readFace() {
    face_.clear();
    while (scan_.skipBlanks() && !scan_.take('#')) {
      Corner corner;
      if (!readCorner(corner)) return;
      face_.push_back(corner);
    }
    if (face_.size() < 3) {
      return add(Severity::error, "obj.bad-face",
                 fmt::format("a face of {} corners", face_.size()));
    }
    if (loose_.corners.size() + face_.size() * 3 > kMaxElements) {
      return add(Severity::error, "obj.too-large", "more triangles than can be numbered");
    }
    if (face_.size() == 3) {
      loose_.corners.insert(loose_.corners.end(), face_.begin(), face_.end());
    } else {
      polygon_.clear();
      for (const Corner& corner : face_) polygon_.push_back(loose_.positions[corner.position]);
      for (const std::uint32_t corner : cutter_.cut(polygon_))
        loose_.corners.push_back(face_[corner]);
      if (cutter_.gaveUp()) {
        add(Severity::warning, "obj.large-face",
            fmt::format("a concave face of {} corners is drawn as if it were convex",
                        face_.size()));
      }
    }
    if (smoothing_ != kNone && face_.front().normal == kNone) {
      const std::size_t triangles = loose_.corners.size() / 3;
      loose_.smoothing.resize(triangles + 2 - face_.size(), kNone);
      loose_.smoothing.resize(triangles, smoothing_);
    }
  }

  /// V, V/T, V//N or V/T/N; on a fault the face is left out.
  bool readCorner(Corner& corner) {
    std::int64_t number = 0;
    if (!scan_.integer(number)) return badCorner();
    if (!resolveIndex(number, loose_.positions.size(), "point", corner.position)) return false;
    if (std::isnan(loose_.positions[corner.position].x)) {
      add(Severity::error, "obj.bad-face", "a face uses a point that is not a number");
      return false;
    }
    if (scan_.take('/')) {
      if (scan_.integer(number)) {
        // Some exporters write V/V/V without any vt: those have no texture coordinates.
        if (loose_.textures.empty()) {
          if (first_without_vt_ == 0) first_without_vt_ = line_;
        } else if (!resolveIndex(number, loose_.textures.size(), "texture coordinate",
                                 corner.texture)) {
          return false;
        }
      }
      if (scan_.take('/') && scan_.integer(number)) {
        if (loose_.normals.empty()) {
          if (first_without_vn_ == 0) first_without_vn_ = line_;
          return scan_.wordEnds() || badCorner();
        }
        if (!resolveIndex(number, loose_.normals.size(), "normal", corner.normal)) return false;
        if (std::isnan(loose_.normals[corner.normal].x)) corner.normal = kNone;
      }
    }
    return scan_.wordEnds() || badCorner();
  }

  bool badCorner() {
    add(Severity::error, "obj.bad-face",
        "a face's corner is not V, V/T, V//N or V/T/N: " + quotedInFault(scan_.word()));
    return false;
  }

  /// From 1, or from the last with -1.
  bool resolveIndex(std::int64_t number, std::size_t count, std::string_view what,
                    std::uint32_t& index) {
    const auto size = static_cast<std::int64_t>(count);
    const std::int64_t from_zero = number < 0 ? number + size : number - 1;
    if (number == 0 || from_zero < 0 || from_zero >= size) {
      add(Severity::error, "obj.bad-index",
          fmt::format("a face uses {} {} of the {} so far", what, number, count));
      return false;
    }
    index = static_cast<std::uint32_t>(from_zero);
    return true;
  }

  /// A number from 1, or 0 or `off`.
  void setSmoothing() {
    scan_.skipBlanks();
    std::int64_t number = 0;
    if (scan_.integer(number) && number >= 0) {
      smoothing_ = static_cast<std::uint32_t>(std::min<std::int64_t>(number, kNone - 1));
      return;
    }
    const std::string_view word = scan_.word();
    smoothing_ = word == "on" ? 1 : 0;
    if (word != "on" && word != "off") badNumber("s");
  }

  void setGroup(std::string group) {
    if (group.empty()) group = object_;
    if (group == part_.group) return;
    closePart();
    part_.group = std::move(group);
  }

  void useMaterial(const std::string& name) {
    const std::uint32_t material = materials_.number(name, line_);
    if (material == part_.material && used_any_) return;
    closePart();
    part_.material = material;
    used_any_ = true;
  }

  /// Ends the run of triangles of the current group and material.
  void closePart() {
    const auto end = static_cast<std::uint32_t>(loose_.corners.size());
    part_.index_count = end - part_.first_index;
    if (part_.index_count > 0) {
      if (!used_any_) {
        part_.material = materials_.number({}, line_);
        used_any_ = true;
      }
      loose_.parts.push_back(part_);
    }
    part_.first_index = end;
  }

  void passOver(std::string_view keyword) {
    static constexpr std::string_view kFreeForm[] = {
        "vp",        "cstype", "deg",   "bmat",   "step",     "curv",     "curv2",
        "surf",      "parm",   "trim",  "hole",   "scrv",     "sp",       "end",
        "con",       "mg",     "bevel", "lod",    "c_interp", "d_interp", "shadow_obj",
        "trace_obj", "ctech",  "stech", "maplib", "usemap"};
    if (keyword == "l" || keyword == "p") {
      return leaveOut("statement", keyword, "lines and points are not drawn");
    }
    if (std::ranges::find(kFreeForm, keyword) != std::end(kFreeForm)) {
      return faults_.leaveOut("statement", keyword, {line_},
                              "free-form geometry and settings of renderers are not drawn",
                              Severity::note, "obj.unsupported");
    }
    faults_.leaveOut("statement", keyword, {line_}, "it is unknown in OBJ", Severity::warning,
                     "obj.unknown-keyword");
  }

  void leaveOut(std::string_view kind, std::string_view name, std::string_view reason) {
    faults_.leaveOut(kind, name, {line_}, std::string(reason));
  }

  void add(Severity severity, std::string_view rule, std::string text) {
    faults_.add(severity, rule, {line_}, std::move(text));
  }

  TextScanner scan_;
  const fs::path& path_;
  const MeshReadOptions& options_;
  FaultList& faults_;
  ObjMaterials materials_;
  int line_ = 0;
  LooseMesh loose_;
  std::string object_;
  MeshPart part_;                                    ///< the one being filled
  bool used_any_ = false;                            ///< part_.material is valid
  std::uint32_t smoothing_ = kNone;                  ///< of the last `s`; kNone: before any
  int first_without_vt_ = 0, first_without_vn_ = 0;  ///< lines of faces; 0: none
  std::vector<Corner> face_;
  std::vector<glm::vec3> polygon_;
  PolygonCutter cutter_;
};

bool looksLikeUtf16(std::string_view text) {
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
         (text.size() >= 4 && ((text[0] == '\0' && text[1] != '\0' && text[2] == '\0') ||
                               (text[1] == '\0' && text[0] != '\0' && text[3] == '\0')));
}

}  // namespace

Result<Mesh> readObj(ByteView bytes, const std::filesystem::path& path,
                     const MeshReadOptions& options, FaultList& faults) {
  if (looksLikeUtf16(textOf(bytes))) {
    return Error{ErrorKind::unsupported, "is UTF-16 text; save it as UTF-8", path.string()};
  }
  return ObjReader(bytes, path, options, faults).read();
}

}  // namespace rocinante
