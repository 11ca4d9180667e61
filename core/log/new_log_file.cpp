#include "core/log/new_log_file.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace rocinante {
namespace {

namespace fs = std::filesystem;

// Attempts; each fails only when another program made or removed the file at the same moment.
constexpr int kMaxTurns = 100;

Error cannotMake(int number, const fs::path& path) {
  return Error{ErrorKind::unreadable, std::string("cannot make the log: ") + std::strerror(number),
               path.string()};
}

Error existsAlready(const fs::path& path) {
  return Error{ErrorKind::refused, "the file already exists and is not overwritten", path.string()};
}

int openUninterrupted(const fs::path& path, int flags) {
  int file = -1;
  do {
    file = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  } while (file < 0 && errno == EINTR);
  return file;
}

/// The target of a link: the log is written there, and the link stays.
fs::path target(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path leads = fs::canonical(path, error);
  return error ? path : leads;
}

}  // namespace

NewLogFile::NewLogFile(NewLogFile&& other) noexcept
    : path_(std::move(other.path_)),
      made_(std::exchange(other.made_, {})),
      old_(std::move(other.old_)),
      part_(std::move(other.part_)),
      sink_(std::move(other.sink_)),
      locked_(other.locked_) {}

NewLogFile::~NewLogFile() {
  if (!made_.empty()) ::unlink(made_.c_str());
}

Result<NewLogFile> NewLogFile::makeFree(const fs::path& path, FileCalls& calls) {
  const int file = openUninterrupted(path, O_WRONLY | O_CREAT | O_EXCL);
  if (file < 0) return errno == EEXIST ? existsAlready(path) : cannotMake(errno, path);
  NewLogFile made;
  made.path_ = path;
  made.sink_ = makeFileSinkOn(file, path.string(), calls);
  const Result<Lock> locked = calls.lock(file, path);
  if (!locked) return locked.error();
  made.locked_ = *locked == Lock::taken;
  // Another program that may overwrite can have replaced it before it was locked.
  if (made.locked_ && !isOpenFile(path, file)) return existsAlready(path);
  made.made_ = path;
  return made;
}

Result<NewLogFile> NewLogFile::makeInPlaceOf(const fs::path& path, HeldFile old, FileCalls& calls) {
  Result<PartFile> part = PartFile::make(path, 0666);
  if (!part) return part.error();
  const Result<int> file = part->writer();
  if (!file) return file.error();
  NewLogFile made;
  made.path_ = path;
  made.old_ = std::make_unique<HeldFile>(std::move(old));
  made.part_ = std::make_unique<PartFile>(std::move(*part));
  made.sink_ = makeFileSinkOn(*file, path.string(), calls);
  const Result<Lock> locked = calls.lock(*file, path);
  if (!locked) return locked.error();
  made.locked_ = *locked == Lock::taken;
  return made;
}

Result<NewLogFile> NewLogFile::openAsItIs(const fs::path& path, FileCalls& calls) {
  const int file = openUninterrupted(path, O_WRONLY);
  if (file < 0) return cannotMake(errno, path);
  NewLogFile made;
  made.path_ = path;
  made.sink_ = makeFileSinkOn(file, path.string(), calls);
  return made;
}

Result<NewLogFile> NewLogFile::make(const fs::path& path, bool overwrite, FileCalls calls) {
  if (!overwrite) return makeFree(path, calls);
  const fs::path place = target(path);
  for (int turn = 0; turn < kMaxTurns; ++turn) {
    Result<HeldFile> old = HeldFile::at(place, HeldFile::For::writing);
    if (!old) return old.error();
    struct stat facts {};
    if (::stat(place.c_str(), &facts) == 0) {
      if (::faccessat(AT_FDCWD, place.c_str(), W_OK, AT_EACCESS) != 0) {
        return cannotMake(errno, place);
      }
      if (!S_ISREG(facts.st_mode)) return openAsItIs(place, calls);
    }
    if (old->holds()) return makeInPlaceOf(place, std::move(*old), calls);
    Result<NewLogFile> made = makeFree(place, calls);
    // Another program created one in between.
    if (made || made.error().kind != ErrorKind::refused) return made;
    if (turn + 1 == kMaxTurns) return made;
  }
  return existsAlready(path);
}

Status NewLogFile::publish() {
  if (part_) {
    if (Status published = part_->publishOver(*old_); !published) return published;
  }
  made_.clear();
  part_.reset();
  old_.reset();
  return {};
}

}  // namespace rocinante
