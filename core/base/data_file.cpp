#include "core/base/data_file.h"

namespace rocinante {

Result<std::filesystem::path> findDataFile(const std::string& name) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  // A build folder has its link there, whatever the installed layout is.
  const auto built = (program / "../share/rocinante").lexically_normal();
  const auto installed = (program / ROCINANTE_DATA_FOLDER).lexically_normal();
  for (const std::filesystem::path& folder : {built, installed}) {
    if (std::filesystem::exists(folder / name, error)) return folder / name;
  }
  const std::string searched =
      built == installed ? built.string() : built.string() + " or " + installed.string();
  return Error{ErrorKind::not_found, name + " is not in " + searched, {}};
}

}  // namespace rocinante
