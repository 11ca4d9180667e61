#include "core/mesh/collada_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/hex_digit.h"
#include "core/mesh/mtl_reader.h"

namespace rocinante {
namespace {

using Element = ColladaDocument::Element;

float clampedComponent(double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); }

/// "file:///C:/a%20b.png" -> "/C:/a b.png"; other escapes stay as they are.
std::string pathOfUri(std::string_view uri) {
  if (uri.starts_with("file://")) uri.remove_prefix(7);
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const std::optional<char> byte = percentByte(uri, i);
    const bool is_escape = byte && *byte != 0;
    path += is_escape ? *byte : uri[i];
    if (is_escape) i += 2;
  }
  return path;
}

TextureWrap wrapNamed(std::string_view name) {
  if (name == "MIRROR") return TextureWrap::mirrored_repeat;
  // What lies outside is one colour with BORDER and NONE: the image's edge, mostly.
  return name == "CLAMP" || name == "BORDER" || name == "NONE" ? TextureWrap::clamp_to_edge
                                                               : TextureWrap::repeat;
}

}  // namespace

/// Reads one <effect> into a material.
class ColladaEffect {
 public:
  ColladaEffect(ColladaMaterials& all, Element& effect, Material& material)
      : document_(all.document_), path_(all.path_), resolve_(all.resolve_), material_(material) {
    scopes_.push_back(&effect);
  }

  void read() {
    Element& effect = *scopes_.front();
    Element* const profile = ColladaDocument::child(effect, "profile_COMMON");
    Element* const technique =
        profile == nullptr ? nullptr : ColladaDocument::child(*profile, "technique");
    Element* shader = nullptr;
    for (const char* name : {"phong", "lambert", "blinn", "constant"}) {
      if (shader == nullptr && technique != nullptr)
        shader = ColladaDocument::child(*technique, name);
    }
    if (shader == nullptr) {
      document_.faults().leaveOut("element", "effect", ColladaDocument::placeOf(effect),
                                  "only a profile_COMMON with constant, lambert, phong or blinn is "
                                  "drawn, so it is grey",
                                  Severity::warning);
      return;
    }
    scopes_.push_back(profile);
    scopes_.push_back(technique);
    if (const auto color = colorOf(*shader, "specular")) material_.specular = glm::vec3(*color);
    if (const auto color = colorOf(*shader, "emission")) {
      material_.emission = glm::vec3(*color);
      // Such a surface only shines.
      if (std::string_view(shader->Name()) == "constant") material_.diffuse = {0, 0, 0, 1};
    }
    readDiffuse(*shader);
    if (const auto shininess = numberOf(*shader, "shininess")) {
      material_.shininess = static_cast<float>(std::clamp(*shininess, 0.0, 1000.0));
    }
    readOpacity(*shader);
  }

  const std::string& texcoord() const { return texcoord_; }

 private:
  void readDiffuse(Element& shader) {
    Element* const diffuse = ColladaDocument::child(shader, "diffuse");
    if (diffuse == nullptr) return;
    if (Element* const texture = ColladaDocument::child(*diffuse, "texture")) {
      material_.diffuse = {1, 1, 1, 1};
      image_ = ColladaDocument::attribute(*texture, "texture");
      texcoord_ = ColladaDocument::attribute(*texture, "texcoord");
      readTexture(*texture);
    } else if (const auto color = colorOf(shader, "diffuse")) {
      material_.diffuse = glm::vec4(glm::vec3(*color), 1.0F);
    }
  }

  /// COLLADA 1.5, "Determining Transparency"; A_ONE and 1 by default.
  void readOpacity(Element& shader) {
    Element* const transparent = ColladaDocument::child(shader, "transparent");
    double opacity = 1;
    bool inverse = false;
    if (transparent != nullptr) {
      const std::string_view mode = ColladaDocument::attribute(*transparent, "opaque");
      const bool by_color = mode == "RGB_ZERO" || mode == "RGB_ONE";
      inverse = mode == "RGB_ZERO" || mode == "A_ZERO";
      Element* const texture = transparent->FirstChildElement("texture");
      const auto color = colorOf(shader, "transparent");
      if (color) {
        // Luminance as ITU-R BT.709 has it.
        opacity = by_color ? color->r * 0.212671 + color->g * 0.715160 + color->b * 0.072169
                           : static_cast<double>(color->a);
      } else if (texture != nullptr && !by_color && !inverse && !image_.empty() &&
                 ColladaDocument::attribute(*texture, "texture") == image_) {
        ColladaDocument::use(*texture);  // the opacity of the image that is drawn
      } else if (by_color || inverse) {
        return;
      }
    }
    opacity *= std::clamp(numberOf(shader, "transparency").value_or(1.0), 0.0, 1.0);
    if (inverse) opacity = 1 - opacity;
    if (opacity > 0) {
      material_.diffuse.a = clampedComponent(opacity);
      return;
    }
    document_.faults().leaveOut(
        "value", "opacity 0", ColladaDocument::placeOf(shader),
        "an invisible surface is drawn opaque, since exporters mean that by it", Severity::warning);
  }

  /// Empty without a colour, or with an image, which stays in the account.
  std::optional<glm::vec4> colorOf(Element& shader, const char* name) {
    Element* const holder = ColladaDocument::child(shader, name);
    if (holder == nullptr) return std::nullopt;
    Element* color = ColladaDocument::child(*holder, "color");
    if (color == nullptr) color = parameterOf(*holder, {"float4", "float3"});
    if (color == nullptr) return std::nullopt;
    std::vector<double> parts = document_.numbers(*color);
    if (parts.size() == 3) parts.push_back(1);
    if (parts.size() != 4) {
      document_.faults().error(
          "collada.bad-value", ColladaDocument::placeOf(*color),
          fmt::format("a colour of <{}> has {} numbers, not 3 or 4", name, parts.size()));
      return std::nullopt;
    }
    for (double& part : parts) part = std::isnan(part) ? 0 : part;
    return glm::vec4(clampedComponent(parts[0]), clampedComponent(parts[1]),
                     clampedComponent(parts[2]), clampedComponent(parts[3]));
  }

  std::optional<double> numberOf(Element& shader, const char* name) {
    Element* const holder = ColladaDocument::child(shader, name);
    if (holder == nullptr) return std::nullopt;
    Element* number = ColladaDocument::child(*holder, "float");
    if (number == nullptr) number = parameterOf(*holder, {"float"});
    if (number == nullptr) return std::nullopt;
    const std::vector<double> one = document_.numbers(*number, 1);
    return one.empty() ? std::nullopt : std::optional(one.front());
  }

  /// What <param ref="..."> within `holder` stands for, when it is one of `kinds`.
  Element* parameterOf(Element& holder, std::initializer_list<const char*> kinds) {
    Element* const reference = ColladaDocument::child(holder, "param");
    if (reference == nullptr) return nullptr;
    Element* const parameter = newParameter(ColladaDocument::attribute(*reference, "ref"));
    for (const char* kind : kinds) {
      Element* const value =
          parameter == nullptr ? nullptr : ColladaDocument::child(*parameter, kind);
      if (value != nullptr) return value;
    }
    document_.faults().warning("collada.bad-reference", ColladaDocument::placeOf(*reference),
                               "<param> refers to " +
                                   quotedInFault(ColladaDocument::attribute(*reference, "ref")) +
                                   ", but its effect has no such <newparam>");
    return nullptr;
  }

  Element* newParameter(std::string_view sid) {
    for (std::size_t i = scopes_.size(); i-- > 0;) {
      for (Element* each = scopes_[i]->FirstChildElement("newparam"); each != nullptr;
           each = each->NextSiblingElement("newparam")) {
        if (sid.empty() || ColladaDocument::attribute(*each, "sid") != sid) continue;
        ColladaDocument::use(*each);
        return each;
      }
    }
    return nullptr;
  }

  void readTexture(Element& texture) {
    readPlacement(texture);
    const std::string name = imageNameOf(texture);
    if (name.empty()) return;
    const std::filesystem::path beside = path_.parent_path();
    const std::string path = pathOfUri(name);
    // As written first: exporters do not escape, and an image may be called "50%25.png".
    const bool as_written = path == name || !textureFile(resolve_, name, beside).path.empty();
    useTexture(resolve_, as_written ? name : path, beside, "mesh.missing-texture",
               ColladaDocument::placeOf(texture), document_.faults(), material_);
  }

  /// Through sampler and surface (1.4), through sampler and <instance_image> (1.5), or, as some
  /// exporters have it, at once.
  std::string imageNameOf(Element& texture) {
    const std::string_view name = ColladaDocument::attribute(texture, "texture");
    std::string id(name);
    if (Element* const parameter = newParameter(name)) {
      Element* const sampler = ColladaDocument::child(*parameter, "sampler2D");
      if (sampler == nullptr) return noImage(texture);
      material_.wrap_u = readWrap(*sampler, "wrap_s");
      material_.wrap_v = readWrap(*sampler, "wrap_t");
      if (Element* const source = ColladaDocument::child(*sampler, "source")) {
        id = imageOfSurface(ColladaDocument::text(*source));
      } else if (Element* const instance = ColladaDocument::child(*sampler, "instance_image")) {
        const std::string_view url = ColladaDocument::attribute(*instance, "url");
        id = url.substr(url.starts_with('#') ? 1 : 0);
      } else {
        return noImage(texture);
      }
    }
    Element* const image = document_.find("image", id);
    if (image == nullptr) {
      // The name of a file, as SketchUp once wrote it.
      return id.find('.') != std::string::npos ? id : noImage(texture);
    }
    Element* const from = ColladaDocument::child(*image, "init_from");
    Element* const reference = from == nullptr ? nullptr : ColladaDocument::child(*from, "ref");
    const std::string file =
        from == nullptr ? "" : ColladaDocument::text(reference == nullptr ? *from : *reference);
    return file.empty() ? noImage(texture) : file;
  }

  std::string imageOfSurface(const std::string& sid) {
    Element* const parameter = newParameter(sid);
    Element* const surface =
        parameter == nullptr ? nullptr : ColladaDocument::child(*parameter, "surface");
    Element* const from =
        surface == nullptr ? nullptr : ColladaDocument::child(*surface, "init_from");
    return from == nullptr ? sid : ColladaDocument::text(*from);
  }

  std::string noImage(const Element& texture) {
    document_.faults().warning("collada.bad-reference", ColladaDocument::placeOf(texture),
                               "<texture> refers to " +
                                   quotedInFault(ColladaDocument::attribute(texture, "texture")) +
                                   ", which leads to no image that is read");
    return {};
  }

  static TextureWrap readWrap(Element& sampler, const char* name) {
    Element* const wrap = ColladaDocument::child(sampler, name);
    return wrap == nullptr ? TextureWrap::repeat : wrapNamed(ColladaDocument::text(*wrap));
  }

  /// Maya's and Max's repetition and shift of an image.
  void readPlacement(Element& texture) {
    Element* const extra = texture.FirstChildElement("extra");
    Element* const technique = extra == nullptr ? nullptr : extra->FirstChildElement("technique");
    if (technique == nullptr || technique->FirstChildElement("repeatU") == nullptr) return;
    ColladaDocument::use(*extra);
    ColladaDocument::use(*technique);
    const auto read = [&](const char* name, double otherwise) {
      Element* const value = ColladaDocument::child(*technique, name);
      if (value == nullptr) return static_cast<float>(otherwise);
      const std::vector<double> one = document_.numbers(*value, 1);
      return static_cast<float>(one.empty() ? otherwise : one.front());
    };
    material_.map_scale = {read("repeatU", 1), read("repeatV", 1)};
    material_.map_offset = {read("offsetU", 0), read("offsetV", 0)};
  }

  ColladaDocument& document_;
  const std::filesystem::path& path_;
  const ResolveFile& resolve_;
  Material& material_;
  std::vector<Element*> scopes_;  ///< of parameters, the outermost first
  std::string_view image_;        ///< what the diffuse <texture> names
  std::string texcoord_;
};

std::uint32_t ColladaMaterials::number(Element& element) {
  const auto [found, is_new] =
      numbers_.emplace(&element, static_cast<std::uint32_t>(materials_.size()));
  if (!is_new) return found->second;
  const std::string_view given = ColladaDocument::attribute(element, "name");
  std::string name(given.empty() ? ColladaDocument::attribute(element, "id") : given);
  Element* const instance = ColladaDocument::child(element, "instance_effect");
  Element* const effect =
      instance == nullptr ? nullptr : document_.follow(*instance, "url", "effect");
  const auto [known, is_new_effect] =
      effects_.emplace(effect, static_cast<std::uint32_t>(materials_.size()));
  if (is_new_effect) {
    Material material;
    material.name = std::move(name);
    std::string texcoord;
    if (effect != nullptr) {
      ColladaEffect reader(*this, *effect, material);
      reader.read();
      texcoord = reader.texcoord();
    }
    materials_.push_back(std::move(material));
    texcoords_.push_back(std::move(texcoord));
  } else {
    materials_.push_back(materials_[known->second]);
    materials_.back().name = std::move(name);
    texcoords_.push_back(texcoords_[known->second]);
  }
  return found->second;
}

std::uint32_t ColladaMaterials::grey() {
  const auto [found, is_new] =
      numbers_.emplace(nullptr, static_cast<std::uint32_t>(materials_.size()));
  if (is_new) {
    materials_.emplace_back();
    texcoords_.emplace_back();
  }
  return found->second;
}

std::vector<Material> ColladaMaterials::takeAll(bool are_points_colored) {
  const auto grey = numbers_.find(nullptr);
  if (are_points_colored && grey != numbers_.end()) {
    materials_[grey->second].diffuse = glm::vec4(1.0F);
  }
  return std::move(materials_);
}

}  // namespace rocinante
