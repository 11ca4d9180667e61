#include "core/bundle/bundle_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

bool isWithin(const fs::path& path, const fs::path& folder) {
  const auto [inside, end] = std::mismatch(path.begin(), path.end(), folder.begin(), folder.end());
  return end == folder.end();
}

fs::path commonOf(const fs::path& a, const fs::path& b) {
  fs::path common;
  for (auto x = a.begin(), y = b.begin(); x != a.end() && y != b.end() && *x == *y; ++x, ++y) {
    common /= *x;
  }
  return common;
}

std::string percentEncoded(std::string_view text, bool (*is_bad)(char)) {
  std::string encoded;
  for (const char c : text) {
    if (is_bad(c)) {
      encoded += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    } else {
      encoded += c;
    }
  }
  return encoded;
}

std::string nameBelow(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  if (relative == ".") return {};
  return percentEncoded(manifestWord(relative.generic_string()), [](char c) { return c == '\\'; });
}

}  // namespace

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

std::string manifestWord(std::string_view text) {
  if (isUtf8(bytesOf(text))) return percentEncoded(text, isControl);
  return percentEncoded(
      text, [](char c) { return isControl(c) || static_cast<unsigned char>(c) >= 0x80; });
}

BundleNames::BundleNames(fs::path main_folder) : common_(std::move(main_folder)) {}

void BundleNames::addOwnRoot(const fs::path& root) {
  const fs::path common = commonOf(common_, root);
  // Only the file system's root is in common: the names of its folders are not revealed.
  if (common == common.root_path() && common_ != common) {
    addOtherRoot(root);
  } else {
    common_ = common;
  }
}

void BundleNames::addOtherRoot(const fs::path& root) {
  if (std::ranges::find(others_, root) == others_.end()) others_.push_back(root);
}

std::string BundleNames::nameOf(const fs::path& path) const {
  if (isWithin(path, common_)) return nameBelow(path, common_);
  for (std::size_t i = 0; i < others_.size(); ++i) {
    if (!isWithin(path, others_[i])) continue;
    const std::string below = nameBelow(path, others_[i]);
    return otherRoots()[i] + (below.empty() ? "" : "/" + below);
  }
  return {};
}

std::vector<std::string> BundleNames::otherRoots() const {
  std::vector<std::string> names;
  for (const fs::path& root : others_) {
    const std::string name = nameBelow(root, root.parent_path());
    names.push_back(fmt::format("search/{}/{}", names.size() + 1, name.empty() ? "root" : name));
  }
  return names;
}

}  // namespace rocinante
