#include "core/bundle/media_type.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rocinante {

std::string mediaTypeOf(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 22> kTypes = {{
      {"bmp", "image/bmp"},        {"csv", "text/csv"},          {"dae", "model/vnd.collada+xml"},
      {"exr", "image/x-exr"},      {"glb", "model/gltf-binary"}, {"gltf", "model/gltf+json"},
      {"gz", "application/gzip"},  {"html", "text/html"},        {"jpeg", "image/jpeg"},
      {"jpg", "image/jpeg"},       {"json", "application/json"}, {"log", "text/plain"},
      {"md", "text/markdown"},     {"mtl", "model/mtl"},         {"obj", "model/obj"},
      {"pdf", "application/pdf"},  {"png", "image/png"},         {"stl", "model/stl"},
      {"tga", "image/x-tga"},      {"toml", "application/toml"}, {"txt", "text/plain"},
      {"urdf", "application/xml"},
  }};
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return "application/octet-stream";
  std::string ending(name.substr(dot + 1));
  std::ranges::transform(ending, ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const auto found = std::ranges::find(kTypes, ending, [](const auto& each) { return each.first; });
  return std::string(found == kTypes.end() ? "application/octet-stream" : found->second);
}

}  // namespace rocinante
