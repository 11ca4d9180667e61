#include "core/search/typed_path.h"

#include <algorithm>
#include <array>
#include <system_error>

namespace rocinante {

namespace fs = std::filesystem;

std::string typedPath(const fs::path& path) {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  const fs::path below = error ? fs::path() : path.lexically_relative(here);
  return below.empty() || *below.begin() == ".." ? path.string() : below.string();
}

bool isMeshOrTexture(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  static constexpr auto kEndings = std::to_array<std::string_view>(
      {".obj", ".mtl", ".stl", ".dae", ".gltf", ".glb", ".bin", ".png", ".jpg", ".jpeg", ".tga",
       ".bmp", ".tif", ".tiff", ".dds", ".exr", ".webp"});
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

}  // namespace rocinante
