#include "core/recording/recorded_files.h"

#include <sys/stat.h>

namespace rocinante {

PieceFile PieceFile::at(const std::filesystem::path& path) {
  struct stat facts {};
  PieceFile file{path, 0, 0};
  if (::stat(path.c_str(), &facts) == 0) {
    file.device = facts.st_dev;
    file.inode = facts.st_ino;
  }
  return file;
}

bool PieceFile::isThere() const {
  struct stat facts {};
  return ::stat(path.c_str(), &facts) == 0 && S_ISREG(facts.st_mode) && facts.st_dev == device &&
         facts.st_ino == inode;
}

}  // namespace rocinante
