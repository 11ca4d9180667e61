#include "core/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>

namespace rocinante {
namespace {

// A program that replaces a file holds the old one's lock for the time of a rename.
constexpr int kTries = 20;
constexpr auto kBetweenTries = std::chrono::milliseconds(5);
// Attempts; each fails only when another program put a new file there meanwhile.
constexpr int kMaxReplacements = 100;

Error heldByAnother(int file, const std::filesystem::path& path) {
  std::string who = "another program";
  struct stat facts {};
  std::ifstream table("/proc/locks");
  const std::string text{std::istreambuf_iterator<char>(table), {}};
  if (::fstat(file, &facts) == 0) {
    if (const auto pid = lockHolder(text, facts.st_ino))
      who += " (pid " + std::to_string(*pid) + ")";
  }
  return Error{ErrorKind::refused,
               who + " is writing this file; choose another name, or end that program first",
               path.string()};
}

Result<Lock> flockWith(int file, int kind, const std::filesystem::path& path) {
  for (int attempt = 1;; ++attempt) {
    if (::flock(file, kind | LOCK_NB) == 0) return Lock::taken;
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return Lock::unsupported;
    if (attempt == kTries) return heldByAnother(file, path);
    std::this_thread::sleep_for(kBetweenTries);
  }
}

/// Opens the file to lock it: NFS wants a writable descriptor. -1 when there is nothing to lock.
int openToLock(const std::filesystem::path& path) {
  struct stat facts {};
  if (::stat(path.c_str(), &facts) != 0 || !S_ISREG(facts.st_mode)) return -1;
  constexpr int kFlags = O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
  const int file = ::open(path.c_str(), O_RDWR | kFlags);
  return file >= 0 ? file : ::open(path.c_str(), O_RDONLY | kFlags);
}

}  // namespace

std::optional<int> lockHolder(std::string_view table, std::uint64_t inode) {
  // "1: FLOCK  ADVISORY  WRITE 612 fe:00:1835 0 EOF"
  std::istringstream lines{std::string(table)};
  const std::string wanted = ":" + std::to_string(inode);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string number, kind, advisory, access, place;
    int pid = 0;
    if (!(words >> number >> kind >> advisory >> access >> pid >> place)) continue;
    if (kind == "FLOCK" && access == "WRITE" && pid > 0 && place.ends_with(wanted)) return pid;
  }
  return std::nullopt;
}

Result<Lock> lockFile(int file, const std::filesystem::path& path) {
  return flockWith(file, LOCK_EX, path);
}

bool isOpenFile(const std::filesystem::path& path, int file) {
  struct stat here {};
  struct stat opened {};
  return ::stat(path.c_str(), &here) == 0 && ::fstat(file, &opened) == 0 &&
         here.st_dev == opened.st_dev && here.st_ino == opened.st_ino;
}

HeldFile::~HeldFile() {
  if (file_ >= 0) ::close(file_);
}

Result<HeldFile> HeldFile::at(const std::filesystem::path& path, For purpose) {
  const int kind = purpose == For::writing ? LOCK_EX : LOCK_SH;
  for (int turn = 0; turn < kMaxReplacements; ++turn) {
    HeldFile held(openToLock(path));
    if (!held.holds()) return held;
    if (const Result<Lock> locked = flockWith(held.file_, kind, path); !locked) {
      return locked.error();
    }
    // While this waited for the lock, another file may have replaced it.
    if (isOpenFile(path, held.file_)) return held;
  }
  return Error{ErrorKind::refused, "other programs keep replacing this file", path.string()};
}

Status mayReplace(const std::filesystem::path& path) {
  const Result<HeldFile> held = HeldFile::at(path, HeldFile::For::replacing);
  if (!held) return held.error();
  return {};
}

}  // namespace rocinante
