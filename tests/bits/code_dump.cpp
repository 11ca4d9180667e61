// Preloaded into a program, writes down all machine code that it makes while it runs: what llvmpipe
// compiles for our shaders above all. Into the folder that ROCINANTE_CODE_DUMP names go one file
// for each piece of code, N.code, and, when the program ends, `maps`, the files that were loaded.
// Code is made in memory that no file backs and that is then made executable (mprotect), or was so
// from the start (mmap); the latter is written when it is given back, or at the end.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

struct Mapping {
  char* start;
  std::size_t size;
};
Mapping open_mappings[256];  // executable from the start
std::atomic<int> pieces{0};
std::atomic_flag busy = ATOMIC_FLAG_INIT;

const char* folder() { return std::getenv("ROCINANTE_CODE_DUMP"); }

void fail(const char* what) {
  std::fprintf(stderr, "code_dump: %s\n", what);
  std::abort();
}

void writeFile(const char* path, const char* bytes, std::size_t size) {
  const int file = ::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) fail("cannot create a file in the folder of ROCINANTE_CODE_DUMP");
  while (size > 0) {
    const ssize_t wrote = ::write(file, bytes, size);
    if (wrote <= 0) fail("cannot write the code");
    bytes += wrote;
    size -= static_cast<std::size_t>(wrote);
  }
  ::close(file);
}

void writePiece(const char* start, std::size_t size) {
  if (folder() == nullptr) return;
  char path[4096];
  std::snprintf(path, sizeof path, "%s/%05d.code", folder(), pieces++);
  writeFile(path, start, size);
}

void copyMaps() {
  char path[4096];
  std::snprintf(path, sizeof path, "%s/maps", folder());
  std::FILE* const from = std::fopen("/proc/self/maps", "re");
  std::FILE* const to = std::fopen(path, "we");
  if (from == nullptr || to == nullptr) fail("cannot copy /proc/self/maps");
  char line[4200];
  while (std::fgets(line, sizeof line, from) != nullptr) std::fputs(line, to);
  std::fclose(from);
  std::fclose(to);
}

[[gnu::destructor]] void atTheEnd() {
  if (folder() == nullptr) return;
  for (const Mapping& mapping : open_mappings) {
    if (mapping.start != nullptr) writePiece(mapping.start, mapping.size);
  }
  copyMaps();
}

void forget(char* start, std::size_t size) {
  while (busy.test_and_set()) {
  }
  for (Mapping& mapping : open_mappings) {
    if (mapping.start != nullptr && mapping.start < start + size &&
        start < mapping.start + mapping.size) {
      writePiece(mapping.start, mapping.size);
      mapping = {};
    }
  }
  busy.clear();
}

void remember(char* start, std::size_t size) {
  while (busy.test_and_set()) {
  }
  bool placed = false;
  for (Mapping& mapping : open_mappings) {
    if (placed || mapping.start != nullptr) continue;
    mapping = {start, size};
    placed = true;
  }
  busy.clear();
  if (!placed) fail("more executable mappings than it has room for");
}

template <typename Function>
Function* systems(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int mprotect(void* start, std::size_t size, int protection) noexcept {
  static auto* const real = systems<int(void*, std::size_t, int)>("mprotect");
  const int answer = real(start, size, protection);
  if (answer == 0 && (protection & PROT_EXEC) != 0) {
    writePiece(static_cast<const char*>(start), size);
  }
  return answer;
}

void* mmap(void* where, std::size_t size, int protection, int flags, int file,
           off_t offset) noexcept {
  static auto* const real = systems<void*(void*, std::size_t, int, int, int, off_t)>("mmap");
  void* const start = real(where, size, protection, flags, file, offset);
  if (start != MAP_FAILED && (protection & PROT_EXEC) != 0 && (flags & MAP_ANONYMOUS) != 0) {
    remember(static_cast<char*>(start), size);
  }
  return start;
}

void* mmap64(void* where, std::size_t size, int protection, int flags, int file,
             off_t offset) noexcept {
  return mmap(where, size, protection, flags, file, offset);
}

int munmap(void* start, std::size_t size) noexcept {
  static auto* const real = systems<int(void*, std::size_t)>("munmap");
  forget(static_cast<char*>(start), size);
  return real(start, size);
}

}  // extern "C"
