#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace rocinante {

/// Opens a module of ours (`librocinante_NAME.so`), a library that costs too much to be linked into
/// every program: from the folder that ROCINANTE_MODULES names, else from ../lib beside the program
/// (a build folder) and from the installed module folder. Never closed: such libraries keep threads
/// and caches until the process ends. not_found, or refused with the loader's reason.
Result<void*> loadModule(const std::string& file_name);

/// Where loadModule would open that module from; empty when it is in none of its folders.
std::filesystem::path findModule(const std::string& file_name);

/// A function of a module; null when it has none of that name.
void* functionOf(void* module, const char* name);

}  // namespace rocinante
