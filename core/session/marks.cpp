#include "core/session/marks.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/duration_text.h"
#include "core/base/json_parse.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

using Json = nlohmann::ordered_json;

/// A time, and the longest text with every byte escaped.
constexpr std::size_t kMaxLineBytes = 64 + 6 * kMaxMarkBytes;

Error systemError(std::string what, const std::filesystem::path& path) {
  return Error{ErrorKind::unreadable, std::move(what) + ": " + std::strerror(errno), path.string()};
}

/// A link is not followed: a log that was shared as a folder would have this write anywhere.
Error notRegular(mode_t mode, const std::filesystem::path& path) {
  return Error{ErrorKind::unreadable,
               S_ISLNK(mode) ? "the marks are a link, which is not followed"
                             : "the marks are not a regular file",
               path.string()};
}

/// Locks a file against other markers while it lives.
class LockedFile {
 public:
  explicit LockedFile(const std::filesystem::path& path)
      : file_(::open(path.c_str(),
                     O_RDWR | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK, 0644)) {
    while (file_ >= 0 && ::flock(file_, LOCK_EX) != 0) {
      if (errno != EINTR) return;
    }
    locked_ = file_ >= 0;
  }
  ~LockedFile() {
    if (file_ >= 0) ::close(file_);
  }
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;

  bool ok() const { return locked_; }
  int number() const { return file_; }

 private:
  int file_;
  bool locked_ = false;
};

/// A JSON string, with DEL and the C1 controls escaped too: terminals execute those.
std::string quotedText(std::string_view text) {
  const std::string json = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string out;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const auto byte = static_cast<unsigned char>(json[i]);
    const unsigned next = i + 1 < json.size() ? static_cast<unsigned char>(json[i + 1]) : 0U;
    const bool c1 = byte == 0xC2 && next < 0xA0;
    if (byte != 0x7F && !c1) {
      out += json[i];
      continue;
    }
    const unsigned code = c1 ? next : 0x7FU;
    out += "\\u00";
    out += kDigits[code >> 4U];
    out += kDigits[code & 15U];
    if (c1) ++i;
  }
  return out;
}

std::optional<LogTime> parseTime(std::string_view text) {
  std::int64_t nanoseconds = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), nanoseconds);
  if (fault != std::errc() || end != text.data() + text.size()) {
    const Result<WallTime> wall = parseRfc3339(text);
    if (!wall) return std::nullopt;
    nanoseconds = wall->time_since_epoch().count();
  }
  if (nanoseconds < 0) return std::nullopt;
  return LogTime(Nanoseconds(nanoseconds));
}

Status checkText(const Event& mark, const std::filesystem::path& log) {
  const auto refused = [&](std::string what) {
    return Error{ErrorKind::bad_argument, std::move(what), log.string()};
  };
  if (mark.text.empty()) return refused("a mark needs a text");
  if (mark.text.size() > kMaxMarkBytes) {
    return refused("the text of a mark has at most " + std::to_string(kMaxMarkBytes) + " bytes");
  }
  if (!isUtf8(bytesOf(mark.text))) return refused("the text of a mark must be UTF-8");
  if (mark.time < LogTime{}) return refused("a mark must not be before 1970");
  return {};
}

}  // namespace

std::filesystem::path marksPath(const std::filesystem::path& log) {
  std::filesystem::path path = log;
  path += ".marks";
  return path;
}

std::string markLine(const Event& mark) {
  return rfc3339Text(WallTime(mark.time.time_since_epoch())) + " " + quotedText(mark.text) + "\n";
}

std::optional<Event> parseMarkLine(std::string_view line) {
  if (line.size() > kMaxLineBytes) return std::nullopt;
  const std::size_t space = line.find(' ');
  if (space == std::string_view::npos) return std::nullopt;
  const std::optional<LogTime> time = parseTime(line.substr(0, space));
  if (!time) return std::nullopt;
  const Json text = parseJsonOrDiscard<Json>(line.substr(space + 1), kSmallJson);
  if (!text.is_string()) return std::nullopt;
  Event mark{*time, {}, text.get<std::string>()};
  if (mark.text.empty() || mark.text.size() > kMaxMarkBytes) return std::nullopt;
  return mark;
}

Result<std::vector<Event>> readMarks(const std::filesystem::path& log) {
  const std::filesystem::path path = marksPath(log);
  struct stat facts {};
  if (::lstat(path.c_str(), &facts) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) return std::vector<Event>{};
    return systemError("cannot read the marks", path);
  }
  if (!S_ISREG(facts.st_mode)) return notRegular(facts.st_mode, path);
  const Result<std::string> content = readFile(path, kMaxMarksFileBytes);
  if (!content) return content.error();
  std::vector<Event> marks;
  std::string_view rest = *content;
  for (std::uint64_t number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.starts_with('#')) continue;
    std::optional<Event> mark = parseMarkLine(line);
    if (!mark) {
      return Error{ErrorKind::damaged, "a mark is a time, a space and a text in quotes",
                   path.string() + ", line " + std::to_string(number)};
    }
    marks.push_back(std::move(*mark));
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Event& a, const Event& b) { return a.time < b.time; });
  return marks;
}

Status addMark(const std::filesystem::path& log, const Event& mark) {
  if (Status allowed = checkText(mark, log); !allowed) return allowed;
  const std::filesystem::path path = marksPath(log);
  // Locked while it is written, so that a write cut short by the disk can be undone.
  const LockedFile file(path);
  struct stat facts {};
  if (!file.ok() && errno == ELOOP) return notRegular(S_IFLNK, path);
  if (!file.ok()) return systemError("cannot open the marks", path);
  if (::fstat(file.number(), &facts) != 0) return systemError("cannot read the marks", path);
  if (!S_ISREG(facts.st_mode)) return notRegular(facts.st_mode, path);
  std::string line = markLine(mark);
  if (facts.st_size > 0) {
    char last = '\n';
    if (::pread(file.number(), &last, 1, facts.st_size - 1) != 1) {
      return systemError("cannot read the marks", path);
    }
    // An editor may have left the last line without its line end.
    if (last != '\n') line.insert(line.begin(), '\n');
  }
  if (static_cast<std::uint64_t>(facts.st_size) + line.size() > kMaxMarksFileBytes) {
    return Error{ErrorKind::refused, "there is no room for more marks", path.string()};
  }
  Status written;
  // One write: a reader sees the whole line.
  const ssize_t count = ::write(file.number(), line.data(), line.size());
  if (count >= 0 && static_cast<std::size_t>(count) < line.size()) errno = ENOSPC;
  if (count != static_cast<ssize_t>(line.size()) ||
      (::fdatasync(file.number()) != 0 && errno != EINVAL)) {
    written = systemError("cannot write the marks", path);
  }
  if (!written && ::ftruncate(file.number(), facts.st_size) != 0) {
    return Error{written.error().kind, written.error().what + "; part of the line was written",
                 path.string()};
  }
  return written;
}

std::string markText(std::string_view text) {
  Json object;
  object["text"] = text;
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<std::string> parseMark(ByteView payload) {
  const Json object = parseJsonOrDiscard<Json>(textOf(payload), kSmallJson);
  if (!object.is_object()) return std::nullopt;
  const auto text = object.find("text");
  if (text == object.end() || !text->is_string()) return std::nullopt;
  return text->get<std::string>();
}

}  // namespace rocinante
