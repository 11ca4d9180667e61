#pragma once

#include <cstdint>
#include <string>

#include "viewer/model/posed_parts.h"

namespace rocinante {

/// Posed geometry as binary STL: metres, z up; without groups, colours and smooth normals, which
/// the format lacks.
class StlWriter {
 public:
  StlWriter();
  void add(const PosedPart& part);
  /// Returns the file; nothing can be added afterwards.
  std::string finish();
  std::uint64_t triangles() const { return triangles_; }

 private:
  std::string bytes_;
  std::uint64_t triangles_ = 0;
};

}  // namespace rocinante
