#include "viewer/gl/shader_cache.h"

#include <sys/statvfs.h>

#include <cstdlib>
#include <filesystem>

namespace rocinante {
namespace {

/// The mapped file has 1.3 MB; what is written besides may fail.
constexpr unsigned long kNeededBytes = 8UL << 20U;

std::filesystem::path cacheFolder() {
  for (const char* name : {"MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR", "XDG_CACHE_HOME"}) {
    if (const char* folder = std::getenv(name); folder != nullptr && *folder != '\0') return folder;
  }
  const char* home = std::getenv("HOME");
  return home != nullptr && *home != '\0' ? std::filesystem::path(home) / ".cache"
                                          : std::filesystem::path();
}

}  // namespace

void avoidShaderCacheOnFullDisk() {
  std::filesystem::path folder = cacheFolder();
  struct statvfs disk {};
  // Mesa makes the folder, on the disk of what is there of its path.
  while (!folder.empty() && ::statvfs(folder.c_str(), &disk) != 0) {
    const std::filesystem::path above = folder.parent_path();
    if (above == folder) return;
    folder = above;
  }
  if (folder.empty() || disk.f_bavail >= kNeededBytes / disk.f_frsize) return;
  // The first is the name since Mesa 22, the second that of earlier ones.
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  ::setenv("MESA_GLSL_CACHE_DISABLE", "true", 1);
}

}  // namespace rocinante
