#include "core/cli/search_options.h"

#include <CLI/CLI.hpp>

namespace rocinante::cli {
namespace {

PackageFolder packageOf(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw CLI::ValidationError("--package", "`" + text + "` is not NAME=DIR");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace

void addSearchFolderOptions(CLI::App& app, ModelSearch& search) {
  app.add_option("--search", search.search,
                 "a root for package:// and relative names; may be repeated")
      ->type_name("DIR")
      ->allow_extra_args(false);
  app.add_option_function<std::vector<std::string>>(
         "--package",
         [&search](const std::vector<std::string>& given) {
           for (const std::string& text : given) search.packages.push_back(packageOf(text));
         },
         "the folder for package://NAME/; may be repeated")
      ->type_name("NAME=DIR")
      ->allow_extra_args(false);
}

void addSearchOptions(CLI::App& app, ModelSearch& search) {
  addSearchFolderOptions(app, search);
  app.add_flag("--search-env", search.search_environment,
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
