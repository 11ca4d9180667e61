#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace rocinante {

/// Opens a module of ours (`librocinante_NAME.so`), a library too expensive to link into every
/// program. Searches the folder that ROCINANTE_MODULES names, or else ../lib beside the program (a
/// build folder) and the installed module folder. Never closed: such libraries keep threads and
/// caches until the process ends. not_found, or refused with the loader's reason.
Result<void*> loadModule(const std::string& file_name);

/// Where loadModule would open the module from; empty when none of its folders has it.
std::filesystem::path findModule(const std::string& file_name);

/// A function of a module; null when the module has no function of that name.
void* functionOf(void* module, const char* name);

}  // namespace rocinante
