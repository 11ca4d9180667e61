#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/mesh/collada_document.h"
#include "core/mesh/mesh_file.h"

namespace rocinante {

/// The materials of a COLLADA file, each read when it is first asked for: the colours, opacity and
/// image of its effect's profile_COMMON. Malformed values are faults and have no effect.
class ColladaMaterials {
 public:
  /// All are borrowed.
  ColladaMaterials(ColladaDocument& document, const std::filesystem::path& path,
                   const ResolveFile& resolve)
      : document_(document), path_(path), resolve_(resolve) {}

  /// Number of a <material> in all().
  std::uint32_t number(ColladaDocument::Element& material);
  /// Number of the grey of surfaces without one.
  std::uint32_t grey();
  /// The name by which its image asks for texture coordinates; empty without an image.
  const std::string& texcoord(std::uint32_t number) const { return texcoords_[number]; }

  /// In order of their first use; ends the reading. The grey is white where points have colours,
  /// which would be darkened by it.
  std::vector<Material> takeAll(bool are_points_colored);

 private:
  friend class ColladaEffect;

  ColladaDocument& document_;
  const std::filesystem::path& path_;
  const ResolveFile& resolve_;
  std::vector<Material> materials_;
  std::vector<std::string> texcoords_;
  std::map<const ColladaDocument::Element*, std::uint32_t> numbers_;  ///< by <material>
  std::map<const ColladaDocument::Element*, std::uint32_t> effects_;  ///< the first that has it
};

}  // namespace rocinante
