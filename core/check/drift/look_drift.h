#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "core/check/drift/drift_list.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// What has drifted in how models look: links, shapes, materials, textures. Remembers what it has
/// hashed, since devices share meshes. Hashes what is drawn, not files: a mesh that was saved anew
/// and decodes to the same triangles has not drifted.
class LookDrift {
 public:
  /// `renamed`: links by their recorded names that have others now.
  void add(const Model& recorded, const Model& given,
           const std::map<std::string, std::string>& renamed, DriftList& drift);

 private:
  using Digest = std::array<std::byte, 16>;

  void compareLinks(const Link& was, const Link& is, DriftList& drift);
  /// What differs between two lists of visuals, as a sentence's end; empty when nothing does.
  std::string shapeDrift(const std::vector<Visual>& was, const std::vector<Visual>& is);
  /// `color_told`: a colour that has changed is told already.
  void compareMaterials(const Visual& was, const Visual& is, const std::string& name,
                        bool color_told, DriftList& drift);
  /// Of meshes that have colours at their points (OBJ, COLLADA, glTF).
  /// True when it told something: without such colours a grey material is another grey.
  bool comparePointColors(const Visual& was, const Visual& is, const std::string& name,
                          DriftList& drift);
  static Digest pointColorsOf(const Visual& visual);
  Digest shapeOf(const Visual& visual);
  Digest partOf(const Mesh& mesh, std::size_t part);
  /// Of the picture's bytes; of its name when it cannot be read.
  Digest textureOf(const Material& material);

  std::map<std::pair<const Mesh*, std::size_t>, Digest> parts_;
  std::map<std::string, Digest> textures_;
};

}  // namespace rocinante
