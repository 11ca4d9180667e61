#include "core/cli/search_options.h"

#include "core/cli/command_line.h"

namespace rocinante::cli {
namespace {

Status addPackage(const std::string& text, ModelSearch& search) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    return Error{ErrorKind::bad_argument, "`" + text + "` is not NAME=DIR", "--package"};
  }
  search.packages.push_back({text.substr(0, equals), text.substr(equals + 1)});
  return {};
}

}  // namespace

void addSearchFolderOptions(CommandLine app, ModelSearch& search) {
  app.addOption("--search", search.search,
                "a root for package:// and relative names; may be repeated")
      .valueName("DIR")
      .oneEach();
  const auto add_package = [&search](const std::string& text) { return addPackage(text, search); };
  app.addParsed("--package", add_package, "the folder for package://NAME/; may be repeated")
      .valueName("NAME=DIR")
      .oneEach();
}

void addSearchOptions(CommandLine app, ModelSearch& search) {
  addSearchFolderOptions(app, search);
  app.addFlag("--search-env", search.search_environment,
              "search ROCINANTE_PATH, AMENT_PREFIX_PATH and ROS_PACKAGE_PATH too");
}

std::vector<std::string> searchWords(const ModelSearch& search) {
  std::vector<std::string> words;
  for (const auto& root : search.search) words.insert(words.end(), {"--search", root.string()});
  for (const PackageFolder& package : search.packages) {
    words.insert(words.end(), {"--package", package.name + "=" + package.folder.string()});
  }
  if (search.search_environment) words.emplace_back("--search-env");
  return words;
}

}  // namespace rocinante::cli
