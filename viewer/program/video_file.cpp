#include "viewer/program/video_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/child_process.h"
#include "core/base/part_file.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxErrorBytes = 2000;

Error videoError(std::string what, const std::filesystem::path& path) {
  return {ErrorKind::refused, std::move(what), path.string()};
}

}  // namespace

struct VideoFile::Impl {
  std::filesystem::path path;
  std::unique_ptr<PartFile> part;
  bool overwrite = false;
  std::size_t picture_bytes = 0;
  std::optional<ChildProcess> child;  ///< its input is ours

  /// ffmpeg's last message, on one line.
  std::string errorText() const {
    std::string text = child->errorOutput(kMaxErrorBytes);
    // Replace the temporary file's name in the message.
    const std::string beside = part->beside().string();
    for (std::size_t at = 0; (at = text.find(beside, at)) != std::string::npos;) {
      text.replace(at, beside.size(), path.string());
      at += path.string().size();
    }
    return onOneLine(std::move(text));
  }

  Status ended() {
    child->closeStream();
    const ChildProcess::End end = child->wait();
    if (end.ok()) return {};
    const std::string why = errorText();
    return videoError("ffmpeg failed (" + end.text() + ")" + (why.empty() ? "" : ": " + why), path);
  }
};

VideoFile::VideoFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VideoFile::~VideoFile() = default;
VideoFile::VideoFile(VideoFile&&) noexcept = default;
VideoFile& VideoFile::operator=(VideoFile&&) noexcept = default;

bool VideoFile::isVideo(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".mp4" || ending == ".mkv" || ending == ".mov" || ending == ".webm";
}

Result<VideoFile> VideoFile::create(const std::filesystem::path& path, int width, int height,
                                    const FrameRate& rate, bool overwrite) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->overwrite = overwrite;
  impl->picture_bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
  Result<PartFile> part = PartFile::make(path);
  if (!part) return part.error();
  impl->part = std::make_unique<PartFile>(std::move(*part));

  // "file:", so that a name is not taken for a protocol or an option.
  std::vector<std::string> arguments{"ffmpeg",
                                     "-hide_banner",
                                     "-loglevel",
                                     "error",
                                     "-y",
                                     "-f",
                                     "rawvideo",
                                     "-pixel_format",
                                     "rgba",
                                     "-video_size",
                                     fmt::format("{}x{}", width, height),
                                     "-framerate",
                                     rate.text(),
                                     "-i",
                                     "pipe:0",
                                     "-an",
                                     "-vf",
                                     "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                     "-pix_fmt",
                                     "yuv420p",
                                     "-fflags",
                                     "+bitexact",
                                     "-flags:v",
                                     "+bitexact",
                                     "-map_metadata",
                                     "-1"};
  if (path.extension() == ".mp4" || path.extension() == ".mov") {
    arguments.insert(arguments.end(), {"-movflags", "+faststart"});
  }
  // Of the format by which ffmpeg knows the output's ending.
  arguments.insert(
      arguments.end(),
      {"-f", path.extension() == ".mkv" ? "matroska" : path.extension().string().substr(1)});
  arguments.push_back("file:" + impl->part->beside().string());
  // Its own process group, so that only we handle Ctrl-C.
  auto child = ChildProcess::start(
      arguments, {.ours = ChildProcess::Ours::input, .own_group = true, .last_signal = SIGKILL});
  if (!child) {
    return videoError(child.error().kind == ErrorKind::not_found
                          ? std::string("--video needs ffmpeg, which is not in PATH; --frames "
                                        "DIR writes pictures for it")
                          : "cannot run ffmpeg: " + child.error().what,
                      path);
  }
  impl->child.emplace(std::move(*child));
  return VideoFile(std::move(impl));
}

Status VideoFile::add(const Picture& picture) {
  Impl& impl = *impl_;
  const auto* bytes = picture.rgba.data();
  std::size_t left = picture.rgba.size();
  if (left != impl.picture_bytes) return videoError("a picture has a different size", impl.path);
  while (left > 0) {
    const ssize_t sent = ::send(impl.child->stream(), bytes, left, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) {
      if (Status end = impl.ended(); !end) return end;
      return videoError("ffmpeg ended before the last picture", impl.path);
    }
    bytes += sent;
    left -= static_cast<std::size_t>(sent);
  }
  return {};
}

Status VideoFile::finish() {
  Impl& impl = *impl_;
  if (Status end = impl.ended(); !end) return end;
  const int file = ::open(impl.part->beside().c_str(), O_RDONLY | O_CLOEXEC);
  struct stat facts {};
  const bool synced = file >= 0 && ::fstat(file, &facts) == 0 && ::fsync(file) == 0;
  if (file >= 0) ::close(file);
  if (!synced) {
    return videoError(std::string("ffmpeg wrote no file: ") + std::strerror(errno), impl.path);
  }
  if (facts.st_size == 0) return videoError("ffmpeg wrote an empty file", impl.path);
  return impl.part->publish(impl.overwrite);
}

}  // namespace rocinante
