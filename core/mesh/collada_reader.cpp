#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "core/document/xml_tags.h"
#include "core/mesh/collada_document.h"
#include "core/mesh/collada_geometry.h"
#include "core/mesh/collada_instances.h"
#include "core/mesh/collada_materials.h"
#include "core/mesh/collada_nodes.h"
#include "core/mesh/mesh_builder.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/mtl_reader.h"
#include "core/mesh/polygon.h"
#include "core/mesh/position_index.h"

namespace rocinante {
namespace {

using Element = ColladaDocument::Element;

/// Numbers given to the values of a source, each once per instance. Equal values have one number:
/// many exporters write one normal for each corner.
class Slots {
 public:
  explicit Slots(const ColladaSource& source)
      : like_(source.count), at_(source.count), instance_(source.count, 0) {
    PositionIndex distinct(source.count);
    std::vector<std::uint32_t> first;
    for (std::uint32_t i = 0; i < source.count; ++i) {
      like_[i] = i;
      const glm::vec3 value(source.at(i, 0), source.at(i, 1), source.at(i, 2));
      if (std::isnan(value.x) || std::isnan(value.y) || std::isnan(value.z)) continue;
      const std::uint32_t number = distinct.numberOf(value);
      if (number == first.size()) first.push_back(i);
      // Far from the origin, different numbers may be equal as floats.
      bool same = true;
      for (std::size_t c = 0; c < 3; ++c)
        same = same && source.at(i, c) == source.at(first[number], c);
      if (same) like_[i] = first[number];
    }
  }

  template <class Make>
  std::uint32_t of(std::uint32_t index, std::uint32_t instance, const Make& make) {
    const std::uint32_t like = like_[index];
    if (instance_[like] != instance) {
      instance_[like] = instance;
      at_[like] = make();
    }
    return at_[like];
  }

 private:
  std::vector<std::uint32_t> like_, at_, instance_;
};

/// From the file's axes to ours: x stays right where it can.
Mat4 turnUp(char up) {
  if (up == 'Y') {
    return Mat4(Vec4(1, 0, 0, 0), Vec4(0, 0, 1, 0), Vec4(0, -1, 0, 0), Vec4(0, 0, 0, 1));
  }
  if (up == 'X') {
    return Mat4(Vec4(0, 0, 1, 0), Vec4(-1, 0, 0, 0), Vec4(0, -1, 0, 0), Vec4(0, 0, 0, 1));
  }
  return Mat4(1.0);
}

class ColladaReader {
 public:
  ColladaReader(const std::filesystem::path& path, const MeshReadOptions& options,
                FaultList& faults)
      : path_(path),
        options_(options),
        faults_(faults),
        resolve_(resolverOf(options)),
        document_(faults),
        geometries_(document_),
        materials_(document_, path, resolve_),
        nodes_(document_),
        instances_(document_, materials_) {}

  Result<Mesh> read(ByteView bytes) {
    if (Status parsed = document_.parse(bytes); !parsed.ok()) return located(parsed.error());
    const Mat4 to_ours = readAsset();
    if (Status read = nodes_.read(); !read.ok()) return located(read.error());
    const Status added = addNodes(to_ours);
    document_.accountForRest();
    if (!added.ok()) return added.error();
    if (loose_.corners.empty()) {
      return located({ErrorKind::damaged, "holds no triangle that can be drawn", {}});
    }
    loose_.materials = materials_.takeAll(!loose_.colors.empty());
    smoothNormals(loose_, options_.smooth_angle_deg);
    return indexedMesh(std::move(loose_));
  }

 private:
  struct Visit {
    std::size_t node;
    Mat4 above;
    std::string_view group;
  };

  Error located(Error error) const {
    error.where = path_.string();
    return error;
  }

  /// Unit and up axis.
  Mat4 readAsset() {
    Element* const asset = ColladaDocument::child(document_.root(), "asset");
    Element* const unit = asset == nullptr ? nullptr : ColladaDocument::child(*asset, "unit");
    Element* const axis = asset == nullptr ? nullptr : ColladaDocument::child(*asset, "up_axis");
    double metres = 1;
    if (unit != nullptr && unit->Attribute("meter") != nullptr) {
      std::string_view text = ColladaDocument::attribute(*unit, "meter");
      text.remove_prefix(std::min(text.find_first_not_of(kXmlBlanks), text.size()));
      const auto read = std::from_chars(text.data(), text.data() + text.size(), metres);
      if (read.ec != std::errc() || !(metres > 0) || !std::isfinite(metres)) {
        faults_.error("collada.bad-value", ColladaDocument::placeOf(*unit),
                      "<unit> needs a positive meter=\"...\", not " + quotedInFault(text),
                      "metres are assumed");
        metres = 1;
      }
    }
    const std::string name = axis == nullptr ? "Y_UP" : ColladaDocument::text(*axis);
    const char up = name == "Z_UP" || name == "X_UP" ? name[0] : 'Y';
    if (up == 'Y' && name != "Y_UP") {
      faults_.warning("collada.bad-value", ColladaDocument::placeOf(*axis),
                      "<up_axis> is not X_UP, Y_UP or Z_UP but " + quotedInFault(name),
                      "Y_UP is assumed");
    }
    if (up != 'Z') {
      faults_.note("mesh.up-axis", {}, fmt::format("the file says {}_UP and is turned to z up", up),
                   "RViz does not turn such files: export with z up to look the same everywhere");
    }
    Mat4 to_ours = turnUp(up);
    for (int i = 0; i < 3; ++i) to_ours[i] *= metres;
    return to_ours;
  }

  // Depth first, in file order, without recursion.
  Status addNodes(const Mat4& to_ours) {
    std::vector<Visit> visits;
    const auto push = [&](const std::vector<std::size_t>& nodes, const Mat4& above,
                          std::string_view group) {
      for (std::size_t i = nodes.size(); i-- > 0;) visits.push_back({nodes[i], above, group});
    };
    push(nodes_.roots(), to_ours, {});
    while (!visits.empty()) {
      const Visit visit = visits.back();
      visits.pop_back();
      const ColladaNode& node = nodes_.at(visit.node);
      const Mat4 to_root = visit.above * node.transform;
      const std::string_view group = node.name.empty() ? visit.group : node.name;
      for (Element* instance : node.meshes) {
        if (Status added = addInstance(*instance, to_root, group); !added.ok()) return added;
      }
      push(node.children, to_root, group);
    }
    return {};
  }

  Status addInstance(Element& instance, const Mat4& to_root, std::string_view group) {
    const ColladaInstances::Instance& shown = instances_.of(instance);
    if (shown.geometry == nullptr) return {};
    ++instance_;
    for (const ColladaPrimitive& primitive : geometries_.of(*shown.geometry)) {
      if (loose_.corners.size() + primitive.corners.size() > kMaxSceneTriangles * 3) {
        return located({ErrorKind::unsupported,
                        fmt::format("has more than {} triangles", kMaxSceneTriangles),
                        {}});
      }
      addPrimitive(primitive, shown, to_root, group);
    }
    return {};
  }

  struct Read {
    const ColladaInput* input = nullptr;
    const ColladaSource* source = nullptr;
    Slots* slots = nullptr;
    bool is_reported = false;
  };

  Read readOf(const ColladaInput* input) {
    Read read{input, input == nullptr ? nullptr : geometries_.source(*input)};
    if (read.source != nullptr) read.slots = &slotsOf(*read.source);
    return read;
  }

  Slots& slotsOf(const ColladaSource& source) {
    return slots_.try_emplace(&source, source).first->second;
  }

  /// The index that a corner has into a source; false when there is none.
  bool indexOf(const ColladaPrimitive& primitive, std::uint32_t corner, Read& read,
               std::uint32_t& index) {
    if (read.source == nullptr) return false;
    index = primitive.index(corner, read.input->offset);
    if (index < read.source->count) return true;
    if (!read.is_reported && reported_.insert(read.input->element).second) {
      faults_.error("collada.bad-index", ColladaDocument::placeOf(*primitive.element),
                    fmt::format("<{}> uses {} {} of {}", primitive.element->Name(),
                                read.input->semantic, index, read.source->count),
                    "such corners have none");
    }
    read.is_reported = true;
    return false;
  }

  void addPrimitive(const ColladaPrimitive& primitive, const ColladaInstances::Instance& shown,
                    const Mat4& to_root, std::string_view group) {
    const ColladaInstances::Bound bound = instances_.boundOf(primitive, shown);
    const glm::dmat3 turn(to_root);
    const double volume = glm::determinant(turn);
    const glm::dmat3 normal_turn = volume != 0 ? glm::transpose(glm::inverse(turn)) : turn;
    Read normals = readOf(primitive.input("NORMAL"));
    Read colors = readOf(primitive.input("COLOR"));
    Read textures = readOf(instances_.texcoordOf(primitive, bound));
    Slots& positions = slotsOf(*primitive.positions);
    colored_.clear();

    MeshPart part{std::string(group), bound.material,
                  static_cast<std::uint32_t>(loose_.corners.size()), 0};
    for (std::size_t i = 0; i + 2 < primitive.corners.size(); i += 3) {
      Corner triangle[3];
      bool sound = true;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t corner = primitive.corners[i + c];
        const std::uint32_t point = primitive.index(corner, primitive.position_offset);
        std::uint32_t index = 0;
        if (indexOf(primitive, corner, colors, index)) {
          triangle[c].position =
              coloredPosition(*primitive.positions, point, *colors.source, index, to_root);
        } else {
          triangle[c].position = positions.of(
              point, instance_, [&] { return addPosition(*primitive.positions, point, to_root); });
        }
        sound = sound && isDrawablePoint(loose_.positions[triangle[c].position]);
        if (indexOf(primitive, corner, textures, index)) {
          triangle[c].texture = textures.slots->of(
              index, instance_, [&] { return addTexture(*textures.source, index); });
        }
        if (indexOf(primitive, corner, normals, index)) {
          const std::uint32_t normal = normals.slots->of(
              index, instance_, [&] { return addNormal(*normals.source, index, normal_turn); });
          if (!std::isnan(loose_.normals[normal].x)) triangle[c].normal = normal;
        }
      }
      if (!sound) {
        faults_.error("mesh.bad-triangle", ColladaDocument::placeOf(*primitive.element),
                      fmt::format("<{}> has a triangle with a corner beyond what can be drawn",
                                  primitive.element->Name()),
                      "it is left out");
        continue;
      }
      if (volume < 0) std::swap(triangle[1], triangle[2]);  // mirrored
      loose_.corners.insert(loose_.corners.end(), triangle, triangle + 3);
    }
    part.index_count = static_cast<std::uint32_t>(loose_.corners.size()) - part.first_index;
    if (part.index_count > 0) loose_.parts.push_back(std::move(part));
  }

  std::uint32_t addPosition(const ColladaSource& source, std::uint32_t index, const Mat4& to_root) {
    const Vec4 p(source.at(index, 0), source.at(index, 1), source.at(index, 2), 1.0);
    loose_.positions.emplace_back(glm::vec3(to_root * p));
    if (!loose_.colors.empty()) loose_.colors.push_back(0xFFFFFFFF);
    return static_cast<std::uint32_t>(loose_.positions.size() - 1);
  }

  /// Colours belong to positions, so one point has as many as it has colours.
  std::uint32_t coloredPosition(const ColladaSource& source, std::uint32_t point,
                                const ColladaSource& colors, std::uint32_t color,
                                const Mat4& to_root) {
    const auto [found, is_new] =
        colored_.try_emplace(std::uint64_t{point} << 32U | color, std::uint32_t{0});
    if (is_new) {
      found->second = addPosition(source, point, to_root);
      loose_.colors.resize(loose_.positions.size(), 0xFFFFFFFF);
      loose_.colors.back() = packedColor(glm::vec4(colors.at(color, 0), colors.at(color, 1),
                                                   colors.at(color, 2), colors.at(color, 3, 1.0)));
    }
    return found->second;
  }

  std::uint32_t addTexture(const ColladaSource& source, std::uint32_t index) {
    const glm::vec2 place(source.at(index, 0), source.at(index, 1));
    const bool sound = std::isfinite(place.x) && std::isfinite(place.y);
    loose_.textures.push_back(sound ? place : glm::vec2(0.0F));
    return static_cast<std::uint32_t>(loose_.textures.size() - 1);
  }

  std::uint32_t addNormal(const ColladaSource& source, std::uint32_t index,
                          const glm::dmat3& normal_turn) {
    const Vec3 turned =
        normal_turn * Vec3(source.at(index, 0), source.at(index, 1), source.at(index, 2));
    const double length = std::sqrt(glm::dot(turned, turned));
    const bool sound = length > 1e-30 && std::isfinite(length);
    loose_.normals.push_back(sound ? glm::vec3(turned / length) : glm::vec3(NAN));
    return static_cast<std::uint32_t>(loose_.normals.size() - 1);
  }

  const std::filesystem::path& path_;
  const MeshReadOptions& options_;
  FaultList& faults_;
  const ResolveFile resolve_;
  ColladaDocument document_;
  ColladaGeometries geometries_;
  ColladaMaterials materials_;
  ColladaNodes nodes_;
  ColladaInstances instances_;
  std::unordered_map<const ColladaSource*, Slots> slots_;
  std::unordered_set<const Element*> reported_;  ///< inputs with a bad index
  std::unordered_map<std::uint64_t, std::uint32_t> colored_;
  std::uint32_t instance_ = 0;
  LooseMesh loose_;
};

}  // namespace

Result<Mesh> readCollada(ByteView bytes, const std::filesystem::path& path,
                         const MeshReadOptions& options, FaultList& faults) {
  if (bytes.size() > kMaxSceneBytes) {
    return Error{
        ErrorKind::unsupported,
        fmt::format("the file is larger than the {} MiB that are read", kMaxSceneBytes >> 20),
        path.string()};
  }
  return ColladaReader(path, options, faults).read(bytes);
}

}  // namespace rocinante
