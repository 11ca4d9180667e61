#include "core/mesh/scene_reader.h"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <map>

#include "core/base/plain_text.h"
#include "core/mesh/collada_guard.h"
#include "core/mesh/mesh_builder.h"
#include "core/mesh/mtl_reader.h"
#include "core/mesh/scene_files.h"
#include "core/mesh/smooth_normals.h"
#include "core/search/file_search.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// Whether it is the importer in use; others must not guess at our files.
bool isWanted(const aiImporterDesc* facts) {
  if (facts == nullptr || facts->mName == nullptr) return false;
  const std::string_view name = facts->mName;
  return name == "Collada Importer";
}

void keepWantedLoaders(Assimp::Importer& importer) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    if (isWanted(importer.GetImporterInfo(i))) continue;
    const std::unique_ptr<Assimp::BaseImporter> loader(importer.GetImporter(i));
    importer.UnregisterLoader(loader.get());
  }
}

/// assimp's message without its file name and line ends.
std::string reasonOf(const char* given) {
  std::string_view text = given;
  const std::size_t dash = text.find(" - ");
  if (text.starts_with("Collada: ") && dash != std::string_view::npos) text.remove_prefix(dash + 3);
  text = text.substr(0, std::min<std::size_t>(text.find_first_of("\r\n"), 200));
  return text.empty() ? std::string("the file is not understood") : plainText(text);
}

Mat4 matrixOfNode(const aiMatrix4x4& m) {
  return Mat4(Vec4(m.a1, m.b1, m.c1, m.d1), Vec4(m.a2, m.b2, m.c2, m.d2),
              Vec4(m.a3, m.b3, m.c3, m.d3), Vec4(m.a4, m.b4, m.c4, m.d4));
}

/// From the file's axes to ours: x stays right where it can.
Mat4 zUpFrom(char up) {
  if (up == 'Y')
    return Mat4(Vec4(1, 0, 0, 0), Vec4(0, 0, 1, 0), Vec4(0, -1, 0, 0), Vec4(0, 0, 0, 1));
  if (up == 'X')
    return Mat4(Vec4(0, 0, 1, 0), Vec4(-1, 0, 0, 0), Vec4(0, -1, 0, 0), Vec4(0, 0, 0, 1));
  return Mat4(1.0);
}

class SceneReader {
 public:
  SceneReader(const aiScene& scene, const fs::path& path, const ResolveFile& resolve,
              const MeshReadOptions& options, FaultList& faults)
      : scene_(scene), path_(path), resolve_(resolve), options_(options), faults_(faults) {}

  Result<Mesh> read(const Mat4& to_ours) {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i) readMaterial(*scene_.mMaterials[i]);
    if (loose_.materials.empty()) loose_.materials.emplace_back();
    if (Status added = addNodes(to_ours); !added.ok()) return added.error();
    if (loose_.corners.empty()) {
      return Error{ErrorKind::damaged, "holds no triangle that can be drawn", path_.string()};
    }
    smoothNormals(loose_, options_.smooth_angle_deg);
    return indexedMesh(std::move(loose_));
  }

 private:
  struct Visit {
    const aiNode* node;
    Mat4 above;
    std::string group;
  };

  // Depth first, in file order, without recursion.
  Status addNodes(const Mat4& to_ours) {
    std::vector<Visit> visits;
    if (scene_.mRootNode != nullptr) visits.push_back({scene_.mRootNode, to_ours, ""});
    while (!visits.empty()) {
      Visit visit = std::move(visits.back());
      visits.pop_back();
      const aiNode& node = *visit.node;
      const Mat4 to_root = visit.above * matrixOfNode(node.mTransformation);
      const std::string_view name = node.mName.C_Str();
      const bool is_own = node.mParent == nullptr;  // made by assimp
      if (!is_own && !name.empty()) visit.group = name;
      for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (Status added = addMesh(*scene_.mMeshes[node.mMeshes[i]], to_root, visit.group);
            !added.ok()) {
          return added;
        }
      }
      for (unsigned i = node.mNumChildren; i-- > 0;) {
        visits.push_back({node.mChildren[i], to_root, visit.group});
      }
    }
    return {};
  }

  Status addMesh(const aiMesh& mesh, const Mat4& to_root, const std::string& group) {
    if (loose_.corners.size() + std::size_t{mesh.mNumFaces} * 3 > kMaxSceneTriangles * 3 ||
        loose_.positions.size() + mesh.mNumVertices > kMaxSceneTriangles * 3) {
      return Error{ErrorKind::unsupported,
                   fmt::format("has more than {} triangles", kMaxSceneTriangles), path_.string()};
    }
    const auto base = static_cast<std::uint32_t>(loose_.positions.size());
    const auto first_texture = static_cast<std::uint32_t>(loose_.textures.size());
    const auto first_normal = static_cast<std::uint32_t>(loose_.normals.size());
    const glm::dmat3 turn(to_root);
    const double volume = glm::determinant(turn);
    const glm::dmat3 normal_turn = volume != 0 ? glm::transpose(glm::inverse(turn)) : turn;
    const unsigned channel = textureChannel(mesh);
    const bool has_textures = mesh.HasTextureCoords(channel);
    if (mesh.HasVertexColors(0)) has_colors_ = true;
    if (has_colors_) loose_.colors.resize(base, 0xFFFFFFFF);

    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& p = mesh.mVertices[i];
      loose_.positions.emplace_back(glm::vec3(to_root * Vec4(p.x, p.y, p.z, 1.0)));
      if (has_textures) {
        const aiVector3D& t = mesh.mTextureCoords[channel][i];
        const bool sound = std::isfinite(t.x) && std::isfinite(t.y);
        loose_.textures.emplace_back(sound ? glm::vec2(t.x, t.y) : glm::vec2(0.0F));
      }
      if (mesh.HasNormals()) {
        const aiVector3D& n = mesh.mNormals[i];
        const Vec3 turned = normal_turn * Vec3(n.x, n.y, n.z);
        const double length = std::sqrt(glm::dot(turned, turned));
        const bool sound = length > 1e-30 && std::isfinite(length);
        loose_.normals.emplace_back(sound ? glm::vec3(turned / length) : glm::vec3(NAN));
      }
      if (!has_colors_) continue;
      loose_.colors.push_back(mesh.HasVertexColors(0) ? colorOf(mesh.mColors[0][i]) : 0xFFFFFFFF);
    }

    MeshPart part{group, std::min(mesh.mMaterialIndex, lastMaterial()),
                  static_cast<std::uint32_t>(loose_.corners.size()), 0};
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices != 3) continue;  // points and lines
      Corner corners[3];
      bool sound = true;
      for (unsigned c = 0; c < 3 && sound; ++c) {
        const std::uint32_t index = face.mIndices[c];
        sound = index < mesh.mNumVertices && isFinite(loose_.positions[base + index]);
        if (!sound) break;
        corners[c].position = base + index;
        if (has_textures) corners[c].texture = first_texture + index;
        if (mesh.HasNormals() && !std::isnan(loose_.normals[first_normal + index].x)) {
          corners[c].normal = first_normal + index;
        }
      }
      if (!sound) {
        faults_.error("mesh.bad-triangle", {},
                      fmt::format("triangle {} of {} has a corner that is not finite", i,
                                  quotedInFault(mesh.mName.C_Str())),
                      "it is left out");
        continue;
      }
      if (volume < 0) std::swap(corners[1], corners[2]);  // mirrored
      loose_.corners.insert(loose_.corners.end(), corners, corners + 3);
    }
    part.index_count = static_cast<std::uint32_t>(loose_.corners.size()) - part.first_index;
    if (part.index_count > 0) loose_.parts.push_back(std::move(part));
    return {};
  }

  static bool isFinite(const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }

  unsigned lastMaterial() const { return static_cast<unsigned>(loose_.materials.size() - 1); }

  std::uint32_t colorOf(const aiColor4D& color) const {
    return packedColor(glm::vec4(shown(aiColor3D(color.r, color.g, color.b)), color.a));
  }

  glm::vec3 shown(const aiColor3D& color) const {
    glm::vec3 rgb(0.0F);
    for (int i = 0; i < 3; ++i) {
      const float component = std::isfinite(color[static_cast<unsigned>(i)])
                                  ? std::clamp(color[static_cast<unsigned>(i)], 0.0F, 1.0F)
                                  : 0.0F;
      rgb[i] = component;
    }
    return rgb;
  }

  unsigned textureChannel(const aiMesh& mesh) const {
    const unsigned channel =
        mesh.mMaterialIndex < channels_.size() ? channels_[mesh.mMaterialIndex] : 0;
    return mesh.HasTextureCoords(channel) ? channel : 0;
  }

  void readMaterial(const aiMaterial& given) {
    Material material;
    material.name = given.GetName().C_Str();
    aiColor3D color;
    if (given.Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS) {
      material.diffuse = glm::vec4(shown(color), 1.0F);
    }
    ai_real opacity = 1;
    if (given.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS && std::isfinite(opacity)) {
      // Some exporters write 0 for an unset value.
      if (opacity > 0) material.diffuse.a = std::min(opacity, 1.0F);
    }
    if (given.Get(AI_MATKEY_COLOR_SPECULAR, color) == aiReturn_SUCCESS) {
      material.specular = shown(color);
    }
    // An emission with a texture would light the whole surface without it.
    if (given.GetTextureCount(aiTextureType_EMISSIVE) == 0 &&
        given.Get(AI_MATKEY_COLOR_EMISSIVE, color) == aiReturn_SUCCESS) {
      material.emission = shown(color);
    }
    ai_real shininess = 0;
    if (given.Get(AI_MATKEY_SHININESS, shininess) == aiReturn_SUCCESS && std::isfinite(shininess)) {
      material.shininess = std::clamp(shininess, 0.0F, 1000.0F);
    }
    channels_.push_back(readTexture(given, material));
    loose_.materials.push_back(std::move(material));
  }

  /// The set of texture coordinates that the material's image uses.
  unsigned readTexture(const aiMaterial& given, Material& material) {
    aiString name;
    if (given.Get(AI_MATKEY_TEXTURE(aiTextureType_DIFFUSE, 0), name) != aiReturn_SUCCESS ||
        name.length == 0) {
      return 0;
    }
    // COLLADA has a colour or an image, never both.
    material.diffuse = glm::vec4(1, 1, 1, material.diffuse.a);
    aiUVTransform placed;
    if (given.Get(AI_MATKEY_UVTRANSFORM(aiTextureType_DIFFUSE, 0), placed) == aiReturn_SUCCESS) {
      material.map_scale = {placed.mScaling.x, placed.mScaling.y};
      material.map_offset = {placed.mTranslation.x, placed.mTranslation.y};
    }
    if (const aiTexture* picture = scene_.GetEmbeddedTexture(name.C_Str())) {
      usePicture(*picture, material);
    } else {
      useTexture(resolve_, name.C_Str(), path_.parent_path(), "mesh.missing-texture", {}, faults_,
                 material);
    }
    int channel = 0;
    given.Get(AI_MATKEY_UVWSRC(aiTextureType_DIFFUSE, 0), channel);
    return channel >= 0 && channel < AI_MAX_NUMBER_OF_TEXTURECOORDS ? static_cast<unsigned>(channel)
                                                                    : 0;
  }

  void usePicture(const aiTexture& picture, Material& material) {
    auto [known, is_new] = pictures_.try_emplace(&picture);
    if (is_new) {
      known->second.first = path_;
      known->second.first += fmt::format("#{}", pictures_.size());
      if (picture.mHeight == 0 && picture.mWidth > 0) {
        const auto* from = reinterpret_cast<const std::byte*>(picture.pcData);
        known->second.second = std::make_shared<const Bytes>(from, from + picture.mWidth);
      }
    }
    material.diffuse_map = known->second.first;
    material.diffuse_bytes = known->second.second;
    if (material.diffuse_bytes) return;
    material.diffuse_map.clear();
    faults_.warning("mesh.missing-texture", {},
                    fmt::format("the picture inside the file for material {} is empty",
                                quotedInFault(material.name)));
  }

  const aiScene& scene_;
  const fs::path& path_;
  const ResolveFile& resolve_;
  const MeshReadOptions& options_;
  FaultList& faults_;
  LooseMesh loose_;
  bool has_colors_ = false;
  std::vector<unsigned> channels_;  ///< of texture coordinates, by material
  std::map<const aiTexture*, std::pair<fs::path, std::shared_ptr<const Bytes>>> pictures_;
};

Result<Mesh> importScene(ByteView bytes, const fs::path& path, const MeshReadOptions& options,
                         FaultList& faults) {
  const std::string name = "scene.dae";
  const ResolveFile resolve = resolverOf(options);
  Assimp::Importer importer;
  keepWantedLoaders(importer);
  auto files = std::make_unique<SceneFiles>(name, bytes, path, resolve);
  const SceneFiles& asked = *files;
  importer.SetIOHandler(files.release());
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = importer.ReadFile(
      name, aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) {
    if (!asked.refused().empty()) {
      return Error{ErrorKind::not_found,
                   "names " + quotedInFault(asked.refused()) +
                       ", which is not found within the search roots",
                   path.string()};
    }
    return Error{ErrorKind::damaged,
                 "cannot be read as COLLADA: " + reasonOf(importer.GetErrorString()),
                 path.string()};
  }
  const char up = upAxisOfCollada(bytes);
  if (up != 'Z') {
    faults.note("mesh.up-axis", {}, fmt::format("the file says {}_UP and is turned to z up", up),
                "RViz does not turn such files: export with z up to look the same everywhere");
  }
  return SceneReader(*scene, path, resolve, options, faults).read(zUpFrom(up));
}

}  // namespace

Result<Mesh> readScene(ByteView bytes, const fs::path& path, const MeshReadOptions& options,
                       FaultList& faults) {
  if (bytes.size() > kMaxSceneBytes) {
    return Error{
        ErrorKind::unsupported,
        fmt::format("the file is larger than the {} MiB that are read", kMaxSceneBytes >> 20),
        path.string()};
  }
  if (std::string problem = problemOfCollada(bytes); !problem.empty()) {
    return Error{ErrorKind::damaged, std::move(problem), path.string()};
  }
  try {
    return importScene(bytes, path, options, faults);
  } catch (const std::exception& fault) {
    return Error{ErrorKind::damaged, "cannot be read: " + reasonOf(fault.what()), path.string()};
  }
}

}  // namespace rocinante
