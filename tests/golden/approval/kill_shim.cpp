// Loaded before a program (LD_PRELOAD), it kills the program right before the Nth step that changes
// what stands on the disk: ROCINANTE_TEST_KILL_AT=N. Steps are files and folders made, renamed and
// removed whose paths hold ROCINANTE_TEST_KILL_UNDER, and every fsync.
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/types.h>

#include <atomic>
#include <cstdarg>
#include <cstdlib>
#include <cstring>

namespace {

void countStep() {
  static const long kill_at = [] {
    const char* const text = std::getenv("ROCINANTE_TEST_KILL_AT");
    return text == nullptr ? 0 : std::atol(text);
  }();
  static std::atomic<long> steps{0};
  if (++steps == kill_at) ::raise(SIGKILL);
}

void countStep(const char* path) {
  const char* const under = std::getenv("ROCINANTE_TEST_KILL_UNDER");
  if (under != nullptr && path != nullptr && std::strstr(path, under) != nullptr) countStep();
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

using Open = int (*)(const char*, int, ...);

int openCounted(Open real, const char* path, int flags, ::mode_t mode) {
  if ((flags & O_CREAT) != 0) countStep(path);
  return real(path, flags, mode);
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  static const auto real = next<Open>("open");
  va_list rest;
  va_start(rest, flags);
  const ::mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, ::mode_t) : 0;
  va_end(rest);
  return openCounted(real, path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  static const auto real = next<Open>("open64");
  va_list rest;
  va_start(rest, flags);
  const ::mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, ::mode_t) : 0;
  va_end(rest);
  return openCounted(real, path, flags, mode);
}

int fsync(int file) {
  static const auto real = next<int (*)(int)>("fsync");
  countStep();
  return real(file);
}

int mkdir(const char* path, ::mode_t mode) noexcept {
  static const auto real = next<int (*)(const char*, ::mode_t)>("mkdir");
  countStep(path);
  return real(path, mode);
}

char* mkdtemp(char* path) noexcept {
  static const auto real = next<char* (*)(char*)>("mkdtemp");
  countStep(path);
  return real(path);
}

int rename(const char* from, const char* to) noexcept {
  static const auto real = next<int (*)(const char*, const char*)>("rename");
  countStep(to);
  return real(from, to);
}

int unlink(const char* path) noexcept {
  static const auto real = next<int (*)(const char*)>("unlink");
  countStep(path);
  return real(path);
}

int remove(const char* path) noexcept {
  static const auto real = next<int (*)(const char*)>("remove");
  countStep(path);
  return real(path);
}

int rmdir(const char* path) noexcept {
  static const auto real = next<int (*)(const char*)>("rmdir");
  countStep(path);
  return real(path);
}

}  // extern "C"
