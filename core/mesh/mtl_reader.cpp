#include "core/mesh/mtl_reader.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/mesh/text_scanner.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::array kPassedOver = {
    "Ka",     "Ni",       "illum",     "Tf",     "map_Ka",  "map_Ks",  "map_Ns", "map_Ke",
    "map_d",  "map_Bump", "map_bump",  "bump",   "norm",    "disp",    "decal",  "refl",
    "Pr",     "Pm",       "Ps",        "Pc",     "Pcr",     "aniso",   "anisor", "map_Pr",
    "map_Pm", "map_Ps",   "sharpness", "map_Tr", "map_aat", "map_refl"};

struct TextureOption {
  std::string_view name;
  int least, most;  ///< how many words follow
  bool numeric;
};
constexpr std::array kTextureOptions = {
    TextureOption{"-s", 1, 3, true},       TextureOption{"-o", 1, 3, true},
    TextureOption{"-t", 1, 3, true},       TextureOption{"-mm", 2, 2, true},
    TextureOption{"-bm", 1, 1, true},      TextureOption{"-boost", 1, 1, true},
    TextureOption{"-texres", 1, 1, true},  TextureOption{"-blendu", 1, 1, false},
    TextureOption{"-blendv", 1, 1, false}, TextureOption{"-clamp", 1, 1, false},
    TextureOption{"-cc", 1, 1, false},     TextureOption{"-imfchan", 1, 1, false},
    TextureOption{"-type", 1, 1, false}};

class MtlReader {
 public:
  MtlReader(std::string_view text, const fs::path& path, const ResolveFile& resolve,
            FaultList& faults, std::vector<Material>& materials)
      : scan_(text), path_(path), resolve_(resolve), faults_(faults), materials_(materials) {
    for (const Material& material : materials) names_.insert(material.name);
  }

  void read() {
    for (; !scan_.atEnd(); scan_.skipLine()) {
      if (!scan_.skipBlanks()) continue;
      line_ = scan_.line();
      const std::string_view keyword = scan_.word();
      if (!keyword.starts_with('#')) readStatement(keyword);
    }
    keepMaterial();
  }

 private:
  void readStatement(std::string_view keyword) {
    if (keyword == "newmtl") {
      keepMaterial();
      material_ = Material{};
      material_.name = scan_.restOfLine();
      opacity_said_ = false;
      begun_ = true;
      begun_line_ = line_;
      return;
    }
    if (std::find(kPassedOver.begin(), kPassedOver.end(), keyword) != kPassedOver.end()) return;
    if (!begun_) {
      add(Severity::warning, "mtl.no-material",
          quotedInFault(keyword) + " comes before any newmtl");
      return;
    }
    double value = 0;
    if (keyword == "Kd") {
      glm::vec3 rgb(material_.diffuse);
      readColor(keyword, rgb);
      material_.diffuse = glm::vec4(rgb, material_.diffuse.a);
    } else if (keyword == "Ks") {
      readColor(keyword, material_.specular);
    } else if (keyword == "Ke") {
      readColor(keyword, material_.emission);
    } else if (keyword == "Ns") {
      // Blender writes small negative ones.
      if (readNumber(keyword, value)) {
        material_.shininess = static_cast<float>(std::clamp(value, 0.0, 1000.0));
      }
    } else if (keyword == "d" || keyword == "Tr") {
      if (scan_.skipBlanks() && scan_.take('-')) scan_.word();  // d -halo
      if (readNumber(keyword, value)) {
        // Some exporters write the opacity into Tr too: where both are given, d is used.
        if (keyword == "Tr" && opacity_said_) return;
        opacity_said_ = opacity_said_ || keyword == "d";
        const double opacity = keyword == "d" ? value : 1.0 - value;
        material_.diffuse.a = static_cast<float>(std::clamp(opacity, 0.0, 1.0));
      }
    } else if (keyword == "map_Kd" || keyword == "map_kd") {
      readTexture();
    } else {
      add(Severity::note, "mtl.unknown-keyword", quotedInFault(keyword) + " is unknown in MTL");
    }
  }

  bool readNumber(std::string_view keyword, double& value) {
    if (scan_.number(value)) return true;
    add(Severity::warning, "mtl.bad-number",
        quotedInFault(keyword) + " needs a number, not " + quotedInFault(scan_.word()));
    return false;
  }

  void readColor(std::string_view keyword, glm::vec3& color) {
    double red = 0;
    if (!readNumber(keyword, red)) return;
    double green = red, blue = red;
    // One number is used for all three.
    if (scan_.skipBlanks() && (!readNumber(keyword, green) || !readNumber(keyword, blue))) return;
    const auto display = [](double value) {
      return static_cast<float>(std::clamp(value, 0.0, 1.0));
    };
    color = {display(red), display(green), display(blue)};
  }

  void readTexture() {
    while (scan_.skipBlanks()) {
      TextScanner ahead = scan_;
      const std::string_view word = ahead.word();
      const auto* option = std::find_if(kTextureOptions.begin(), kTextureOptions.end(),
                                        [&](const TextureOption& o) { return o.name == word; });
      if (option == kTextureOptions.end()) break;
      scan_ = ahead;
      readTextureOption(*option);
    }
    std::string name = scan_.restOfLine();
    if (name.size() > 2 && name.front() == '"' && name.back() == '"') {
      name = name.substr(1, name.size() - 2);
    }
    if (name.empty()) {
      add(Severity::warning, "mtl.missing-texture", "map_Kd names no file");
      return;
    }
    useTexture(resolve_, name, path_.parent_path(), "mtl.missing-texture", {line_}, faults_,
               material_);
  }

  void readTextureOption(const TextureOption& option) {
    double values[3] = {0, 0, 0};
    int count = 0;
    for (; count < option.most && scan_.skipBlanks(); ++count) {
      if (!option.numeric) {
        scan_.word();
      } else if (!scan_.number(values[count])) {
        break;
      }
    }
    if (count < option.least) {
      add(Severity::warning, "mtl.bad-number",
          "map_Kd's option " + std::string(option.name) + " lacks its value");
      return;
    }
    if (option.name == "-s") {
      material_.map_scale = {static_cast<float>(values[0]),
                             count > 1 ? static_cast<float>(values[1]) : 1.0F};
    } else if (option.name == "-o") {
      material_.map_offset = {static_cast<float>(values[0]), static_cast<float>(values[1])};
    }
  }

  void keepMaterial() {
    if (!begun_) return;
    begun_ = false;
    // Exporters write a black Kd beside an image, which would make it black.
    if (!material_.diffuse_map.empty() && glm::vec3(material_.diffuse) == glm::vec3(0)) {
      material_.diffuse = glm::vec4(1, 1, 1, material_.diffuse.a);
    }
    if (!names_.insert(material_.name).second) {
      faults_.add(
          Severity::warning, "mtl.duplicate-material", {begun_line_},
          "material " + quotedInFault(material_.name) + " is defined twice; the first is used");
      return;
    }
    materials_.push_back(std::move(material_));
  }

  void add(Severity severity, std::string_view rule, std::string text, std::string hint = {}) {
    faults_.add(severity, rule, {line_}, std::move(text), std::move(hint));
  }

  TextScanner scan_;
  const fs::path& path_;
  const ResolveFile& resolve_;
  FaultList& faults_;
  std::vector<Material>& materials_;
  std::set<std::string> names_;
  Material material_;
  bool begun_ = false;
  bool opacity_said_ = false;  // by d
  int begun_line_ = 0;
  int line_ = 0;
};

}  // namespace

void readMtl(std::string_view text, const fs::path& path, const ResolveFile& resolve,
             FaultList& faults, std::vector<Material>& materials) {
  MtlReader(text, path, resolve, faults, materials).read();
}

FoundFile textureFile(const ResolveFile& resolve, std::string name, const fs::path& beside) {
  std::vector<std::string> names = {name};
  if (name.find('\\') != std::string::npos) {
    std::replace(name.begin(), name.end(), '\\', '/');
    names.push_back(name);
  }
  const std::string bare = name.substr(name.rfind('/') + 1);
  if (!bare.empty()) names.insert(names.end(), {bare, "../materials/textures/" + bare});
  FoundFile best;
  for (const std::string& each : names) {
    FoundFile found = resolve(each, beside);
    if (!found.path.empty()) return found;
    if (best.why == FoundFile::Why::missing) best = std::move(found);
  }
  return best;
}

void useTexture(const ResolveFile& resolve, const std::string& name, const fs::path& beside,
                std::string_view rule, Place place, FaultList& faults, Material& material) {
  const FoundFile found = textureFile(resolve, name, beside);
  material.diffuse_map = found.path;
  material.missing_map = found.path.empty() ? name : std::string();
  if (!found.path.empty()) return;
  const bool is_missing = found.why == FoundFile::Why::missing;
  faults.warning(rule, place,
                 "the texture " + quotedPathInFault(name) + " of material " +
                     quotedInFault(material.name) +
                     (is_missing ? " is not found" : " is not used: " + found.problem()),
                 is_missing ? "textures are looked for as named, beside the file and in "
                              "../materials/textures, inside the search roots"
                            : found.hint());
}

ResolveFile resolverOf(const MeshReadOptions& options) {
  if (options.resolve) return options.resolve;
  return [](const std::string& name, const fs::path& beside) {
    FoundFile found;
    const fs::path below = fs::path(name).lexically_normal();
    if (name.empty() || name.find('\0') != std::string::npos || below.is_absolute() ||
        *below.begin() == "..") {
      return found;
    }
    std::error_code ignored;
    const fs::path file = (beside / below).lexically_normal();
    if (!fs::is_regular_file(file, ignored)) return found;
    found.why = FoundFile::Why::found;
    found.path = file;
    return found;
  };
}

}  // namespace rocinante
