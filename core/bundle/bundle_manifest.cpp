#include "core/bundle/bundle_manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/base/json_parse.h"

namespace rocinante {
namespace {

// Not ordered_json: its time is quadratic in the number of keys, which untrusted text chooses.
using Json = nlohmann::json;
using Why = FoundFile::Why;

constexpr std::size_t kMaxNameBytes = 1024;
constexpr std::size_t kMaxPartBytes = 255;
constexpr std::size_t kSha256Digits = 64;

constexpr std::array<std::pair<Why, std::string_view>, 7> kReasons = {{
    {Why::found, "found"},
    {Why::found_elsewhere, "found_elsewhere"},
    {Why::missing, "missing"},
    {Why::outside, "outside"},
    {Why::no_file, "no_file"},
    {Why::remote, "remote"},
    {Why::expression, "expression"},
}};

std::string_view textOf(Why why) {
  return std::ranges::find(kReasons, why, [](const auto& each) { return each.first; })->second;
}

bool isFound(Why why) { return why == Why::found || why == Why::found_elsewhere; }

bool isFolderName(std::string_view name) { return name.empty() || isBundleName(name); }

/// Reads a manifest and keeps the first fault.
class ManifestReader {
 public:
  explicit ManifestReader(const Json& root) : root_(root) {}

  BundleManifest read() {
    BundleManifest manifest;
    manifest.main = text(root_, "main");
    for (const Json& each : list("files", kMaxBundledFiles)) readFile(each, manifest);
    for (const Json& each : list("names", kMaxBundledNames)) readName(each, manifest);
    readFolders("search", manifest.search);
    readFolders("folders", manifest.folders);
    readPackages(manifest.packages);
    if (!files_.contains(manifest.main)) fail("its main file is not among its files");
    return manifest;
  }

  const std::string& fault() const { return fault_; }

 private:
  void fail(std::string what) {
    if (fault_.empty()) fault_ = std::move(what);
  }

  std::string text(const Json& object, const char* key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    if (found != object.end() && found->is_string()) return found->get<std::string>();
    fail(fmt::format("it lacks the string `{}`", key));
    return {};
  }

  const Json& list(const char* key, std::size_t most) {
    static const Json kNone = Json::array();
    const auto found = root_.find(key);
    if (found == root_.end() || !found->is_array()) {
      fail(fmt::format("it lacks the array `{}`", key));
      return kNone;
    }
    if (found->size() > most) {
      fail(fmt::format("its array `{}` is longer than {}", key, most));
      return kNone;
    }
    return *found;
  }

  void readFile(const Json& each, BundleManifest& manifest) {
    BundleManifest::File file;
    file.name = text(each, "name");
    file.sha256 = text(each, "sha256");
    if (!fault_.empty()) return;
    if (!isBundleName(file.name)) return fail("the name of one of its files is not allowed");
    if (!files_.insert(file.name).second) return fail(file.name + " is in it twice");
    if (file.sha256.size() != kSha256Digits ||
        file.sha256.find_first_not_of("0123456789abcdef") != std::string::npos) {
      return fail("the SHA-256 of " + file.name + " is not 64 hexadecimal digits");
    }
    const auto size = each.find("bytes");
    if (size == each.end() || !size->is_number_unsigned()) {
      return fail("the size of " + file.name + " is not a whole number");
    }
    file.bytes = size->get<std::uint64_t>();
    if (file.bytes > kMaxBundledBytes - total_bytes_) {
      return fail(fmt::format("it is larger than {} MiB", kMaxBundledBytes >> 20));
    }
    total_bytes_ += file.bytes;
    manifest.files.push_back(std::move(file));
  }

  void readName(const Json& each, BundleManifest& manifest) {
    BundleManifest::Name name;
    name.in = text(each, "in");
    name.written = text(each, "says");
    const std::string why = text(each, "why");
    const auto reason = std::ranges::find(kReasons, why, [](const auto& it) { return it.second; });
    if (reason == kReasons.end()) fail("it gives an unknown reason for a name");
    if (!fault_.empty()) return;
    name.why = reason->first;
    if (isFound(name.why)) name.means = text(each, "means");
    if (isFound(name.why) && !files_.contains(name.means)) {
      return fail("a name in it means a file that it does not have");
    }
    if (!isFolderName(name.in)) return fail("a folder in it has a name that is not allowed");
    manifest.names.push_back(std::move(name));
  }

  void readFolders(const char* key, std::vector<std::string>& folders) {
    for (const Json& each : list(key, kMaxBundledFiles)) {
      if (!each.is_string() || !isFolderName(each.get_ref<const std::string&>())) {
        return fail("a folder in it has a name that is not allowed");
      }
      folders.push_back(each.get<std::string>());
    }
  }

  // Absent where each package is in a folder of its name.
  void readPackages(std::map<std::string, std::string>& packages) {
    const auto found = root_.find("packages");
    if (found == root_.end()) return;
    if (!found->is_object() || found->size() > kMaxBundledFiles) {
      return fail("its `packages` is not an array of folders");
    }
    for (const auto& [name, folder] : found->items()) {
      if (!folder.is_string() || !isFolderName(folder.get_ref<const std::string&>())) {
        return fail("a folder in it has a name that is not allowed");
      }
      packages.emplace(name, folder.get<std::string>());
    }
  }

  const Json& root_;
  std::set<std::string, std::less<>> files_;
  std::uint64_t total_bytes_ = 0;
  std::string fault_;
};

}  // namespace

bool isBundleName(std::string_view name) {
  if (name.empty() || name.size() > kMaxNameBytes) return false;
  const auto is_bad = [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\';
  };
  if (std::ranges::any_of(name, is_bad)) return false;
  while (true) {
    const std::size_t slash = std::min(name.find('/'), name.size());
    const std::string_view part = name.substr(0, slash);
    if (part.empty() || part == "." || part == ".." || part.size() > kMaxPartBytes) return false;
    if (slash == name.size()) return true;
    name.remove_prefix(slash + 1);
  }
}

std::string manifestText(const BundleManifest& manifest) {
  using OrderedJson = nlohmann::ordered_json;
  OrderedJson root;
  root["format"] = 1;
  root["main"] = manifest.main;
  root["files"] = OrderedJson::array();
  for (const BundleManifest::File& file : manifest.files) {
    root["files"].push_back({{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  }
  root["names"] = OrderedJson::array();
  for (const BundleManifest::Name& name : manifest.names) {
    OrderedJson one = {{"in", name.in}, {"says", name.written}, {"why", textOf(name.why)}};
    if (!name.means.empty()) one["means"] = name.means;
    root["names"].push_back(std::move(one));
  }
  root["search"] = manifest.search;
  root["folders"] = manifest.folders;
  if (!manifest.packages.empty()) root["packages"] = manifest.packages;
  return root.dump(1) + "\n";
}

Result<BundleManifest> parseManifest(ByteView text, const std::string& where) {
  const auto refuse = [&](ErrorKind kind, const std::string& why) {
    return Error{kind, "the list of the cell's files cannot be used: " + why, where};
  };
  if (text.size() > kMaxManifestBytes) return refuse(ErrorKind::damaged, "it is too large");
  const Result<Json> parsed = parseJson<Json>(textOf(text));
  if (!parsed) return refuse(parsed.error().kind, parsed.error().what);
  const Json& root = *parsed;
  if (!root.is_object()) return refuse(ErrorKind::damaged, "it is not a JSON object");
  const auto format = root.find("format");
  if (format == root.end() || !format->is_number_unsigned()) {
    return refuse(ErrorKind::damaged, "it states no format");
  }
  if (*format != 1) {
    return refuse(ErrorKind::unsupported,
                  fmt::format("it has format {}; this program reads format 1", format->dump()));
  }
  ManifestReader reader(root);
  BundleManifest manifest = reader.read();
  if (!reader.fault().empty()) return refuse(ErrorKind::damaged, reader.fault());
  return manifest;
}

}  // namespace rocinante
