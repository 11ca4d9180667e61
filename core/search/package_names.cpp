#include "core/search/package_names.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "core/document/xml_tags.h"
#include "core/search/search_facts.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxFolders = 4096;
constexpr std::size_t kMaxPackageBytes = 64 * 1024;  // <name> is at the top
constexpr std::size_t kMaxPackageName = 255;

/// The text of <package><name>, without blanks around it.
std::string nameInPackageXml(std::string_view text) {
  XmlTags tags(text);
  int depth = 0;
  for (XmlTag tag; tags.next(tag);) {
    if (depth == 0 && tag.starts && tag.name != "package") return {};
    if (depth == 1 && tag.starts && !tag.ends && tag.name == "name") {
      const auto from =
          static_cast<std::size_t>(tag.inner.data() + tag.inner.size() + 1 - text.data());
      std::string_view name = text.substr(from, text.find('<', from) - from);
      name.remove_prefix(std::min(name.find_first_not_of(kXmlBlanks), name.size()));
      name = name.substr(0, name.find_last_not_of(kXmlBlanks) + 1);
      return name.size() > kMaxPackageName ? std::string() : std::string(name);
    }
    if (tag.starts) ++depth;
    if (tag.ends) --depth;
  }
  return {};
}

std::string readName(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  std::ifstream stream(file, std::ios::binary);
  std::string text(kMaxPackageBytes, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return nameInPackageXml(text);
}

}  // namespace

std::string PackageNames::nameOf(const std::filesystem::path& folder) {
  const std::lock_guard lock(mutex_);
  const auto [known, is_new] = names_.try_emplace(folder);
  if (is_new) {
    if (facts_ != nullptr) facts_->noteContent(folder / "package.xml");
    known->second = readName(folder / "package.xml");
  }
  return known->second;
}

std::vector<std::filesystem::path> PackageNames::foldersIn(const std::filesystem::path& folder) {
  const std::lock_guard lock(mutex_);
  const auto [known, is_new] = folders_.try_emplace(folder);
  if (!is_new) return known->second;
  if (facts_ != nullptr) facts_->noteMore();
  std::error_code error;
  std::filesystem::directory_iterator each(folder, error);
  for (; !error && each != std::filesystem::directory_iterator(); each.increment(error)) {
    std::error_code ignored;
    if (each->is_directory(ignored)) known->second.push_back(each->path());
    if (known->second.size() >= kMaxFolders) break;
  }
  std::sort(known->second.begin(), known->second.end());
  return known->second;
}

}  // namespace rocinante
