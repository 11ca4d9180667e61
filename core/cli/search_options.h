#pragma once

#include <string>
#include <vector>

#include "core/base/model_search.h"

namespace CLI {
class App;
}

namespace rocinante::cli {

/// Adds --search DIR, --package NAME=DIR and --search-env to a program or subcommand that loads
/// models. `search` must outlive `app`.
void addSearchOptions(CLI::App& app, ModelSearch& search);
/// Adds the first two alone: for programs that always search the environment.
void addSearchFolderOptions(CLI::App& app, ModelSearch& search);

/// The same options as command line words.
std::vector<std::string> searchWords(const ModelSearch& search);

}  // namespace rocinante::cli
