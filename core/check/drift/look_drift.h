#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "core/check/drift/drift_list.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// Reports drift in how models look: links, shapes, materials, textures. Caches hashes, since
/// devices share meshes. Hashes the decoded triangles, not files: a mesh that was saved again with
/// the same triangles has not drifted.
class LookDrift {
 public:
  /// `renamed`: renamed links by their recorded names.
  void add(const Model& recorded, const Model& given,
           const std::map<std::string, std::string>& renamed, DriftList& drift);

 private:
  using Digest = std::array<std::byte, 16>;

  void compareLinks(const Link& was, const Link& is, DriftList& drift);
  /// The difference between two lists of visuals, as the end of a message; empty when there is
  /// none.
  std::string shapeDrift(const std::vector<Visual>& was, const std::vector<Visual>& is);
  /// How two meshes differ: groups of an OBJ, triangles, size.
  std::string shapeText(const Visual& was, const Visual& is);
  /// `is_color_reported`: a changed colour is already reported.
  void compareMaterials(const Visual& was, const Visual& is, const std::string& name,
                        bool is_color_reported, DriftList& drift);
  /// For meshes with vertex colours (OBJ, COLLADA, glTF). True when it reported something: losing
  /// vertex colours also changes the default material.
  bool comparePointColors(const Visual& was, const Visual& is, const std::string& name,
                          DriftList& drift);
  static Digest pointColorsOf(const Visual& visual);
  Digest shapeOf(const Visual& visual);
  Digest partOf(const Mesh& mesh, std::size_t part);
  /// Of the image's bytes; of its name when it cannot be read.
  Digest textureOf(const Material& material);

  std::map<std::pair<const Mesh*, std::size_t>, Digest> parts_;
  std::map<std::string, Digest> textures_;
};

}  // namespace rocinante
