#include "viewer/program/render_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "viewer/program/measured_files.h"

namespace rocinante {
namespace {

/// "f.png" with `middle` before its extension.
std::filesystem::path withMiddle(const std::filesystem::path& file, const std::string& middle) {
  std::filesystem::path named = file;
  named.replace_filename(file.stem().string() + middle + file.extension().string());
  return named;
}

}  // namespace

std::string fileNamePart(std::string_view text) {
  constexpr std::size_t kMaxBytes = 60;
  std::string part;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_' || (c == '.' && !part.empty());
    if (plain) {
      part += c;
    } else if (!part.empty() && part.back() != '_') {
      part += '_';
    }
  }
  part.resize(std::min(part.size(), kMaxBytes));
  while (!part.empty() && (part.back() == '_' || part.back() == '.')) part.pop_back();
  return part.empty() ? "unnamed" : part;
}

std::filesystem::path RenderFiles::ofCamera(const std::filesystem::path& file,
                                            std::size_t camera) const {
  return cameras.size() > 1 ? withMiddle(file, "." + fileNamePart(cameras[camera])) : file;
}

std::filesystem::path RenderFiles::ofMoment(const std::filesystem::path& file, std::size_t moment,
                                            std::size_t camera) const {
  return ofCamera(moments.size() > 1 ? withMiddle(file, fmt::format("-{:05}", moment + 1)) : file,
                  camera);
}

std::filesystem::path RenderFiles::frame(std::size_t moment, std::size_t camera) const {
  std::string name = fmt::format("frame-{:05}", moment + 1);
  if (!moments[moment].event.empty()) name += "-" + fileNamePart(moments[moment].event);
  name += "." + frame_type;
  return cameras.size() > 1 ? frames / fileNamePart(cameras[camera]) / name : frames / name;
}

Status RenderFiles::check(bool overwrite) const {
  std::set<std::filesystem::path> files;
  Status answer;
  const auto add = [&](const std::filesystem::path& file) {
    std::error_code ignored;
    if (!answer) return;
    if (!files.insert(file.lexically_normal()).second) {
      answer =
          Error{ErrorKind::bad_argument, "two pictures would have this file name", file.string()};
    } else if (!overwrite && std::filesystem::exists(file, ignored)) {
      answer = Error{ErrorKind::refused, "the file exists; --force replaces it", file.string()};
    }
  };
  if (!sheet.empty()) add(sheet);
  for (std::size_t camera = 0; camera < cameras.size(); ++camera) {
    if (!output.empty()) add(ofCamera(output, camera));
    if (!video.empty()) add(ofCamera(video, camera));
    for (std::size_t moment = 0; moment < moments.size(); ++moment) {
      if (!frames.empty()) add(frame(moment, camera));
      for (const auto* file : {&identity, &depth}) {
        if (file->empty()) continue;
        add(ofMoment(*file, moment, camera));
        add(legendPath(ofMoment(*file, moment, camera)));
      }
    }
  }
  return answer;
}

}  // namespace rocinante
