#include "core/mesh/mtl_reader.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/mesh/text_scanner.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// Statements that are not used, in lower case, and why.
struct PassedOver {
  std::string_view keyword, reason;
};
constexpr std::string_view kNoRelief = "surfaces are drawn without relief";
constexpr std::string_view kNoReflections = "reflections are not drawn";
constexpr std::string_view kOneImage = "only the image of map_Kd is drawn";
constexpr std::string_view kNoPbr = "physically based values are not drawn";
constexpr PassedOver kPassedOver[] = {
    {"ka", "the light around is the renderer's"},
    {"ni", "refraction is not drawn"},
    {"illum", "all surfaces are drawn with a colour and a highlight, as by illum 2"},
    {"tf", "light that passes is not coloured"},
    {"sharpness", kNoReflections},
    {"map_ka", kOneImage},
    {"map_ks", kOneImage},
    {"map_ns", kOneImage},
    {"map_ke", kOneImage},
    {"map_d", "the opacity drawn is that of map_Kd's image"},
    {"map_tr", "the opacity drawn is that of map_Kd's image"},
    {"decal", kOneImage},
    {"map_aat", "textures are always filtered"},
    {"map_bump", kNoRelief},
    {"bump", kNoRelief},
    {"norm", kNoRelief},
    {"disp", kNoRelief},
    {"refl", kNoReflections},
    {"map_refl", kNoReflections},
    {"pr", kNoPbr},
    {"pm", kNoPbr},
    {"ps", kNoPbr},
    {"pc", kNoPbr},
    {"pcr", kNoPbr},
    {"aniso", kNoPbr},
    {"anisor", kNoPbr},
    {"map_pr", kNoPbr},
    {"map_pm", kNoPbr},
    {"map_ps", kNoPbr}};

struct TextureOption {
  std::string_view name;
  int least, most;  ///< how many words follow
  bool numeric;
};
constexpr std::size_t kLongestStatement = 16;
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
  void readStatement(std::string_view given) {
    // Exporters write map_kd, map_KD and Map_Kd.
    std::string keyword(given.substr(0, kLongestStatement));
    std::ranges::transform(keyword, keyword.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if (keyword == "newmtl") {
      keepMaterial();
      material_ = Material{};
      material_.name = scan_.restOfLine();
      has_opacity_ = false;
      begun_ = true;
      begun_line_ = line_;
      return;
    }
    const auto* const passed = std::ranges::find(kPassedOver, keyword, &PassedOver::keyword);
    if (passed != std::end(kPassedOver)) {
      if (!hasNoEffect(keyword)) {
        faults_.leaveOut("statement", given, {line_}, std::string(passed->reason));
      }
      return;
    }
    if (!begun_) {
      add(Severity::warning, "mtl.no-material", quotedInFault(given) + " comes before any newmtl");
      return;
    }
    double value = 0;
    if (keyword == "kd") {
      glm::vec3 rgb(material_.diffuse);
      readColor(given, rgb);
      material_.diffuse = glm::vec4(rgb, material_.diffuse.a);
    } else if (keyword == "ks") {
      readColor(given, material_.specular);
    } else if (keyword == "ke") {
      readColor(given, material_.emission);
    } else if (keyword == "ns") {
      // Blender writes small negative ones.
      if (readNumber(given, value)) {
        material_.shininess = static_cast<float>(std::clamp(value, 0.0, 1000.0));
      }
    } else if (keyword == "d" || keyword == "tr") {
      if (scan_.skipBlanks() && scan_.take('-')) {
        faults_.leaveOut("option", "-" + std::string(scan_.word()), {line_},
                         "opacity does not depend on the angle of view");
      }
      if (readNumber(given, value)) {
        // Some exporters write the opacity into Tr too: where both are given, d is used.
        if (keyword == "tr" && has_opacity_) return;
        has_opacity_ = has_opacity_ || keyword == "d";
        const double opacity = keyword == "d" ? value : 1.0 - value;
        material_.diffuse.a = static_cast<float>(std::clamp(opacity, 0.0, 1.0));
      }
    } else if (keyword == "map_kd") {
      readTexture();
    } else {
      faults_.leaveOut("statement", given, {line_}, "it is unknown in MTL", Severity::note,
                       "mtl.unknown-keyword");
    }
  }

  /// Whether a passed-over statement asks for what is drawn anyway.
  bool hasNoEffect(std::string_view keyword) {
    std::array<double, 3> values{};
    std::size_t count = 0;
    while (count < values.size() && scan_.number(values[count])) ++count;
    if (count == 0) return false;
    if (keyword == "illum") return values[0] == 2;
    const auto all = [&](double value) {
      return std::all_of(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count),
                         [&](double each) { return each == value; });
    };
    return keyword == "ka" ? all(0) : (keyword == "ni" || keyword == "tf") && all(1);
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
    readOptions(scan_);
    std::string name = scan_.restOfLine();
    // Options behind the name, unless they are part of it.
    const std::size_t behind = optionsBehind(name);
    if (behind < name.size() && textureFile(resolve_, name, path_.parent_path()).path.empty()) {
      TextScanner options(std::string_view(name).substr(behind));
      readOptions(options);
      name.erase(behind);
      name.erase(name.find_last_not_of(" \t") + 1);
    }
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

  static const TextureOption* optionNamed(std::string_view word) {
    const auto* const option = std::ranges::find(kTextureOptions, word, &TextureOption::name);
    return option == std::end(kTextureOptions) ? nullptr : option;
  }

  /// Where the first option behind a file's name begins; its length without one.
  static std::size_t optionsBehind(std::string_view name) {
    for (std::size_t at = name.find(" -"); at != std::string_view::npos;
         at = name.find(" -", at + 1)) {
      const std::size_t end = std::min(name.find_first_of(" \t", at + 1), name.size());
      if (at > 0 && optionNamed(name.substr(at + 1, end - at - 1)) != nullptr) return at + 1;
    }
    return name.size();
  }

  void readOptions(TextScanner& scan) {
    while (scan.skipBlanks()) {
      TextScanner ahead = scan;
      const TextureOption* const option = optionNamed(ahead.word());
      if (option == nullptr) return;
      scan = ahead;
      readTextureOption(scan, *option);
    }
  }

  void readTextureOption(TextScanner& scan, const TextureOption& option) {
    double values[3] = {0, 0, 0};
    std::string_view word;
    int count = 0;
    for (; count < option.most && scan.skipBlanks(); ++count) {
      if (!option.numeric) {
        word = scan.word();
      } else if (!scan.number(values[count])) {
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
    } else if (option.name == "-clamp" && (word == "on" || word == "off")) {
      material_.wrap_u = word == "on" ? TextureWrap::clamp_to_edge : TextureWrap::repeat;
      material_.wrap_v = material_.wrap_u;
    } else {
      faults_.leaveOut("option", option.name, {line_}, "images are drawn as they are");
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
  bool has_opacity_ = false;  // by d
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
