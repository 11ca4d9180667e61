#include "core/search/found_file.h"

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

std::string FoundFile::problem() const {
  switch (why) {
    case Why::found:
    case Why::found_elsewhere:
      return {};
    case Why::missing:
      return detail.empty() ? "there is no such file within the search roots" : detail;
    case Why::outside:
      return "it is outside the search roots";
    case Why::no_file:
      return "it is not a regular file";
    case Why::remote:
      return "files are not fetched from the network";
    case Why::expression:
      return "its name is a template expression";
  }
  return {};
}

std::string FoundFile::hint() const {
  if (!advice.empty()) return advice;
  switch (why) {
    case Why::found:
    case Why::found_elsewhere:
    case Why::no_file:
      return {};
    case Why::missing:
    case Why::outside:
      return "add its folder to `search` in the cell, or use --search";
    case Why::remote:
      return "download it and name the file";
    case Why::expression:
      return "expand the template first: xacro model.xacro > model.urdf";
  }
  return {};
}

}  // namespace rocinante
