#include "viewer/ui/model/camera_append.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/document/toml_node.h"
#include "core/document/toml_table.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxCellBytes = 64U << 20U;

std::string vectorText(const Vec3& vector) {
  return fmt::format("[{}, {}, {}]", vector.x, vector.y, vector.z);
}

std::string cameraText(const CellCamera& camera, const char* line_end) {
  std::string text = line_end;
  const auto add = [&](std::string_view line) { text += std::string(line) + line_end; };
  add("[[camera]]");
  add("name = " + tomlText(camera.name));
  add("eye = " + vectorText(camera.eye));
  add("target = " + vectorText(camera.target));
  if (camera.up != Vec3(0, 0, 1)) add("up = " + vectorText(camera.up));
  if (camera.ortho_height_m) {
    add(fmt::format("ortho_height_m = {}", *camera.ortho_height_m));
  } else {
    add(fmt::format("fov_deg = {}", camera.fov_deg));
  }
  return text;
}

const TomlNode* findKey(const TomlNode& table, std::string_view key) {
  const auto found = std::ranges::find(table.entries, key, &TomlNode::Entry::key);
  return found == table.entries.end() ? nullptr : &found->value;
}

bool hasCamera(const TomlNode& document, const std::string& name) {
  const TomlNode* const cameras = findKey(document, "camera");
  if (cameras == nullptr) return false;
  return std::ranges::any_of(cameras->items, [&](const TomlNode& camera) {
    const TomlNode* const called = findKey(camera, "name");
    return called != nullptr && called->text == name;
  });
}

Error systemError(const std::string& what, const fs::path& file) {
  return {ErrorKind::refused, what + ": " + std::strerror(errno), file.string()};
}

/// Appends in one write; what a full disk has kept of it is taken back.
Status appendBytes(const fs::path& file, const std::string& bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor < 0) return systemError("cannot append to the cell", file);
  const off_t before = ::lseek(descriptor, 0, SEEK_END);
  const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
  Status done;
  if (written != static_cast<ssize_t>(bytes.size()) || ::fsync(descriptor) != 0) {
    if (written >= 0 && written != static_cast<ssize_t>(bytes.size())) errno = ENOSPC;
    done = systemError("cannot append to the cell", file);
    if (before >= 0) (void)!::ftruncate(descriptor, before);
  }
  ::close(descriptor);
  return done;
}

/// What is to be appended.
Result<std::string> addedText(const std::string& cell, const CellCamera& camera,
                              const std::string& file) {
  const auto document = parseToml(cell, file);
  if (!document.ok()) return document.error();
  if (hasCamera(*document, camera.name)) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("the cell has a camera called {} already", camera.name), file};
  }
  const bool windows = cell.find("\r\n") != std::string::npos;
  const char* const line_end = windows ? "\r\n" : "\n";
  std::string added = cell.empty() || cell.ends_with('\n') ? "" : line_end;
  added += cameraText(camera, line_end);
  const auto whole = parseToml(cell + added, file);
  if (!whole.ok() || !hasCamera(*whole, camera.name)) {
    return Error{ErrorKind::bad_argument,
                 "the cell writes its cameras as a list; a [[camera]] cannot be appended", file};
  }
  return added;
}

}  // namespace

Result<std::string> withCamera(const std::string& cell, const CellCamera& camera,
                               const std::string& file) {
  const auto added = addedText(cell, camera, file);
  if (!added.ok()) return added.error();
  return cell + *added;
}

Status appendCamera(const fs::path& file, const CellCamera& camera) {
  if (file.extension() != ".toml") {
    return Error{ErrorKind::bad_argument, "only a cell (*.cell.toml) can keep a camera",
                 file.string()};
  }
  const auto text = readFile(file, kMaxCellBytes);
  if (!text.ok()) return text.error();
  const auto added = addedText(*text, camera, file.string());
  if (!added.ok()) return added.error();
  return appendBytes(file, *added);
}

}  // namespace rocinante
