#include "viewer/backdrop/video_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/duration_text.h"

namespace rocinante {
namespace {

/// Pictures that are cheaper to read over than to begin anew.
constexpr std::size_t kReadOver = 24;
constexpr std::size_t kMaxProbeBytes = std::size_t{96} << 20U;

Error whyNot(const Error& fault, const std::string& program, const std::filesystem::path& file) {
  if (fault.kind == ErrorKind::not_found) {
    return {ErrorKind::refused,
            "a video as backdrop needs " + program +
                ", which is not in PATH: install the package ffmpeg, or give a folder of pictures",
            file.string()};
  }
  return {ErrorKind::refused, program + " cannot read this as a video: " + fault.what,
          file.string()};
}

/// "file:", so that a name is no protocol and no option; and nothing that a file names from afar.
std::string named(const std::filesystem::path& file) { return "file:" + file.string(); }

Result<std::string> probed(const std::filesystem::path& file) {
  auto pipe = ChildPipe::start({"ffprobe", "-v", "error", "-protocol_whitelist", "file",
                                "-select_streams", "v:0", "-show_entries",
                                "packet=pts_time,flags:stream=width,height:format=start_time",
                                "-of", "compact", named(file)});
  if (!pipe) return whyNot(pipe.error(), "ffprobe", file);
  std::string text;
  std::vector<std::uint8_t> part(std::size_t{1} << 16U);
  while (true) {
    const auto got = pipe->read(part, {});
    if (!got) return whyNot(got.error(), "ffprobe", file);
    text.append(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(*got));
    if (text.size() > kMaxProbeBytes) {
      return Error{ErrorKind::refused, "the video is too long for a backdrop", file.string()};
    }
    if (*got < part.size()) break;
  }
  if (Status end = pipe->ended(); !end) return whyNot(end.error(), "ffprobe", file);
  return text;
}

}  // namespace

Result<VideoReader> VideoReader::open(const std::filesystem::path& file) {
  const auto text = probed(file);
  if (!text) return text.error();
  auto facts = parseVideoFacts(*text);
  if (!facts) return Error{facts.error().kind, facts.error().what, file.string()};
  VideoReader reader;
  reader.file_ = file;
  reader.facts_ = std::move(*facts);
  return reader;
}

Status VideoReader::beginAt(std::size_t number) {
  std::vector<std::string> words{"ffmpeg",    "-nostdin",     "-v", "error", "-protocol_whitelist",
                                 "file,pipe", "-noautorotate"};
  if (number > 0) {
    // Between two pictures: the first one that comes is the wanted one, whatever the rounding.
    const Nanoseconds before = facts_.times[number - 1];
    const Nanoseconds between = before + (facts_.times[number] - before) / 2 - facts_.start;
    words.insert(words.end(), {"-ss", secondsText(between, 6)});
  }
  words.insert(words.end(),
               {"-i", named(file_), "-map", "0:v:0", "-fps_mode", "passthrough", "-sws_flags",
                "bitexact+accurate_rnd", "-f", "rawvideo", "-pix_fmt", "rgba", "pipe:1"});
  auto pipe = ChildPipe::start(words);
  if (!pipe) return whyNot(pipe.error(), "ffmpeg", file_);
  decoder_ = std::move(*pipe);
  next_ = number;
  return {};
}

Result<Picture> VideoReader::read(std::size_t number, const std::function<bool()>& stopped) {
  if (!decoder_ || number < next_ || number > next_ + kReadOver) {
    if (Status begun = beginAt(number); !begun) return begun.error();
  }
  Picture picture{facts_.width, facts_.height, {}};
  picture.rgba.resize(static_cast<std::size_t>(facts_.width) *
                      static_cast<std::size_t>(facts_.height) * 4);
  while (true) {
    const auto got = decoder_->read(picture.rgba, stopped);
    if (!got) {
      decoder_.reset();
      return whyNot(got.error(), "ffmpeg", file_);
    }
    if (*got < picture.rgba.size()) {
      const Status end = decoder_->ended();
      decoder_.reset();
      if (!end) return whyNot(end.error(), "ffmpeg", file_);
      return Error{ErrorKind::damaged,
                   fmt::format("ffmpeg decodes {} of the {} pictures of this video", next_,
                               facts_.times.size()),
                   file_.string()};
    }
    if (next_++ == number) return picture;
  }
}

}  // namespace rocinante
