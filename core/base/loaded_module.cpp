#include "core/base/loaded_module.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace rocinante {
namespace {

std::vector<std::filesystem::path> moduleFolders() {
  if (const char* chosen = std::getenv("ROCINANTE_MODULES"); chosen != nullptr && *chosen != '\0') {
    return {chosen};
  }
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  if (program.empty()) return {};
  return {(program / "../lib").lexically_normal(),
          (program / ROCINANTE_MODULE_FOLDER).lexically_normal()};
}

}  // namespace

std::filesystem::path findModule(const std::string& file_name) {
  for (const std::filesystem::path& folder : moduleFolders()) {
    std::error_code error;
    if (std::filesystem::exists(folder / file_name, error)) return folder / file_name;
  }
  return {};
}

Result<void*> loadModule(const std::string& file_name) {
  if (const std::filesystem::path file = findModule(file_name); !file.empty()) {
    void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library != nullptr) return library;
    return Error{ErrorKind::refused, std::string("it cannot be loaded: ") + ::dlerror(), {}};
  }
  std::string looked_in;
  for (const std::filesystem::path& folder : moduleFolders()) {
    looked_in += (looked_in.empty() ? "" : " or ") + folder.string();
  }
  return Error{
      ErrorKind::not_found,
      file_name + " is not in " + (looked_in.empty() ? "any folder that is searched" : looked_in),
      {}};
}

void* functionOf(void* module, const char* name) { return ::dlsym(module, name); }

}  // namespace rocinante
