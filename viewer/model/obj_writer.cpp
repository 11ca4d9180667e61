#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "core/mesh/mesh.h"
#include "viewer/model/model_writers.h"

namespace rocinante {
namespace {

constexpr std::uint32_t kUnused = 0xFFFFFFFF;

void addLine(std::string& text, std::string_view word, const Vec3& v, std::string_view rest = "") {
  fmt::format_to(std::back_inserter(text), "{} {} {} {}{}\n", word, static_cast<float>(v.x) + 0.0F,
                 static_cast<float>(v.y) + 0.0F, static_cast<float>(v.z) + 0.0F, rest);
}

/// " r g b" of 0xRRGGBBAA.
std::string colorWords(std::uint32_t color) {
  const auto shade = [&](unsigned shift) {
    return static_cast<float>(color >> shift & 0xFFU) / 255.0F;
  };
  return fmt::format(" {} {} {}", shade(24), shade(16), shade(8));
}

/// The ending of a picture's bytes, for one that is not a file.
std::string_view endingOf(ByteView picture) {
  const std::string_view text = textOf(picture);
  if (text.starts_with("\x89PNG")) return ".png";
  if (text.starts_with("\xFF\xD8\xFF")) return ".jpg";
  return text.starts_with("RIFF") ? ".webp" : "";
}

}  // namespace

std::string PlainNames::of(std::string_view name) {
  std::string plain(name);
  for (char& c : plain) {
    const bool keeps = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '_' || c == '.' || c == '-';
    if (!keeps) c = '_';
  }
  if (plain.empty() || plain.front() == '.') plain.insert(plain.begin(), '_');
  std::string unique = plain;
  for (std::size_t i = 2; !taken_.insert(unique).second; ++i) {
    const std::size_t dot = plain.find_last_of('.');
    const std::size_t stem = dot == std::string::npos || dot == 0 ? plain.size() : dot;
    unique = fmt::format("{}-{}{}", plain.substr(0, stem), i, plain.substr(stem));
  }
  return unique;
}

ObjWriter::ObjWriter(std::string material_file, std::string texture_folder)
    : texture_folder_(std::move(texture_folder)) {
  obj_ = fmt::format("# metres, z up\nmtllib {}\n", material_file);
}

void ObjWriter::beginGroup(std::string_view name) {
  fmt::format_to(std::back_inserter(obj_), "g {}\n", name);
}

void ObjWriter::add(const PosedPart& part) {
  const Mesh& mesh = *part.mesh;
  const MeshPart& run = *part.part;
  const std::span indices(mesh.indices.data() + run.first_index, run.index_count);
  const auto [low, high] = std::ranges::minmax(indices);
  std::vector<std::uint32_t> number(high - low + 1, kUnused);  // by vertex, from `low`
  const bool pictured = !part.material.diffuse_map.empty();
  std::uint32_t used = 0;
  std::string coordinates, normals;
  const MapPlacing placing(part.material);
  const bool turned = part.material.map_rotation != 0.0F;  // MTL has only -s and -o
  for (const std::uint32_t index : indices) {
    if (number[index - low] != kUnused) continue;
    number[index - low] = used++;
    const Vertex& vertex = mesh.vertices[index];
    addLine(obj_, "v", worldPoint(part, vertex.position),
            part.tinted ? colorWords(mesh.colors[index]) : std::string());
    addLine(normals, "vn", worldNormal(part, vertex.normal));
    if (pictured) {
      const glm::vec2 at = turned ? placing.of(vertex.texture) : vertex.texture;
      fmt::format_to(std::back_inserter(coordinates), "vt {} {}\n", at.x, at.y);
    }
  }
  obj_ += coordinates;
  obj_ += normals;
  fmt::format_to(std::back_inserter(obj_), "usemtl {}\n", materialName(part.material));
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    std::array<std::uint64_t, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) corner[k] = number[indices[i + k] - low];
    if (part.mirrored) std::swap(corner[1], corner[2]);
    obj_ += 'f';
    for (const std::uint64_t at : corner) {
      if (pictured) {
        fmt::format_to(std::back_inserter(obj_), " {}/{}/{}", points_ + at + 1, corners_ + at + 1,
                       normals_ + at + 1);
      } else {
        fmt::format_to(std::back_inserter(obj_), " {}//{}", points_ + at + 1, normals_ + at + 1);
      }
    }
    obj_ += '\n';
  }
  points_ += used;
  normals_ += used;
  if (pictured) corners_ += used;
  triangles_ += indices.size() / 3;
}

std::string ObjWriter::materialName(const Material& material) {
  std::string look;
  const auto out = std::back_inserter(look);
  const auto& d = material.diffuse;
  fmt::format_to(out, "Kd {} {} {}\n", d.r, d.g, d.b);
  const float opacity = material.alpha_mode == AlphaMode::opaque ? 1.0F : d.a;
  if (opacity != 1.0F) fmt::format_to(out, "d {}\n", opacity);
  const auto color = [&](std::string_view key, const glm::vec3& c) {
    if (c != glm::vec3(0.0F)) fmt::format_to(out, "{} {} {} {}\n", key, c.r, c.g, c.b);
  };
  color("Ks", material.specular);
  color("Ke", material.emission);
  if (material.shininess != 0.0F) fmt::format_to(out, "Ns {}\n", material.shininess);
  if (!material.diffuse_map.empty()) {
    look += "map_Kd";
    const bool turned = material.map_rotation != 0.0F;
    if (!turned && material.map_scale != glm::vec2(1.0F)) {
      fmt::format_to(out, " -s {} {} 1", material.map_scale.x, material.map_scale.y);
    }
    if (!turned && material.map_offset != glm::vec2(0.0F)) {
      fmt::format_to(out, " -o {} {} 0", material.map_offset.x, material.map_offset.y);
    }
    fmt::format_to(out, " {}\n", textureName(material));
  }
  // Materials that only lost what makes them different become one.
  const std::string whole = fmt::format(
      "{}\n{}{} {} {} {}", material.name, look, static_cast<int>(material.alpha_mode),
      material.alpha_cutoff, static_cast<int>(material.wrap_u), static_cast<int>(material.wrap_v));
  if (judged_.insert(whole).second) nameLosses(material);
  const auto [known, is_new] = materials_.try_emplace(material.name + '\n' + look);
  if (is_new) {
    known->second = material_names_.of(material.name.empty() ? "material" : material.name);
    mtl_ += fmt::format("{}newmtl {}\n{}", mtl_.empty() ? "" : "\n", known->second, look);
  }
  return known->second;
}

void ObjWriter::nameLosses(const Material& material) {
  const auto lose = [&](std::string_view kind, std::string_view what, std::string_view reason) {
    left_out_.leaveOut({.kind = std::string(kind),
                        .name = std::string(what),
                        .reason = std::string(reason),
                        .severity = Severity::warning});
  };
  const bool is_cut = material.alpha_mode == AlphaMode::mask;
  const bool is_pictured = !material.diffuse_map.empty();
  if (is_cut && (is_pictured || material.diffuse.a < 1.0F)) {
    lose("alpha mode", "mask", "MTL has only opacity: holes are blended");
  } else if (material.alpha_mode == AlphaMode::opaque && is_pictured) {
    lose("alpha mode", "opaque", "MTL has only opacity: the alpha of a texture is blended");
  }
  if (!is_pictured) return;
  for (const TextureWrap wrap : {material.wrap_u, material.wrap_v}) {
    if (wrap == TextureWrap::repeat) continue;
    lose("texture wrap", wrap == TextureWrap::clamp_to_edge ? "clamp" : "mirror",
         "textures of MTL repeat");
  }
}

std::string ObjWriter::textureName(const Material& material) {
  const std::filesystem::path& file = material.diffuse_map;
  const auto [known, is_new] = texture_names_.try_emplace(file);
  if (is_new) {
    std::string name = file.filename().string();
    if (material.diffuse_bytes) name += endingOf(*material.diffuse_bytes);
    known->second = texture_folder_ + "/" + picture_names_.of(name);
    textures_.push_back({file, material.diffuse_bytes, known->second});
  }
  return known->second;
}

}  // namespace rocinante
