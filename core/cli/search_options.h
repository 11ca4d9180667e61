#pragma once

#include <string>
#include <vector>

#include "core/base/model_search.h"
#include "core/cli/command_line.h"

namespace rocinante::cli {

/// Adds --search DIR, --package NAME=DIR and --search-env to a program or subcommand that loads
/// models. `search` must outlive `app`.
void addSearchOptions(CommandLine app, ModelSearch& search);
/// Adds the first two alone: for programs that always search the environment.
void addSearchFolderOptions(CommandLine app, ModelSearch& search);

/// The same options as command line words.
std::vector<std::string> searchWords(const ModelSearch& search);

}  // namespace rocinante::cli
