#include "viewer/ui/program/content_request.h"

#include <utility>

#include "core/base/plain_text.h"
#include "core/bundle/cell_or_log.h"
#include "core/foreign/recordings/opened_recording.h"

namespace rocinante {
namespace {

/// What stays whatever is shown.
ContentRequest optionsOf(const ContentRequest& shown) {
  ContentRequest request;
  request.where = shown.where;
  request.trust = shown.trust;
  request.decoders = shown.decoders;
  request.keep = shown.keep;
  return request;
}

/// "bag/" is "bag", by whose name the window is called.
std::filesystem::path wholePath(const std::filesystem::path& given) {
  std::error_code fault;
  const std::filesystem::path whole = std::filesystem::absolute(given, fault).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

Status checkFile(const std::filesystem::path& file) {
  std::error_code fault;
  if (std::filesystem::is_directory(file, fault) && !isForeignRecording(file)) {
    return Error{ErrorKind::bad_argument, "a folder cannot be shown; open a file of it",
                 file.string()};
  }
  if (!std::filesystem::exists(file, fault)) {
    return Error{ErrorKind::not_found, "there is no such file", file.string()};
  }
  return {};
}

}  // namespace

std::string typedText(const std::vector<std::string>& endpoints) {
  std::string all;
  for (const std::string& endpoint : endpoints) {
    const std::size_t way = endpoint.find("://");
    const std::size_t at = endpoint.rfind('@');
    const bool has_password = way != endpoint.npos && at != endpoint.npos && at > way;
    all += (all.empty() ? "" : " ") + (has_password ? endpoint.substr(0, way + 3) + "...@" : "") +
           endpoint.substr(has_password ? at + 1 : 0);
  }
  return plainText(all);
}

std::string endpointsText(const ContentRequest& request) {
  std::string text;
  if (!request.live) return text;
  for (const Endpoint& endpoint : *request.live) {
    text += (text.empty() ? "" : " ") + endpoint.text();
  }
  return text;
}

std::string ContentRequest::title() const {
  if (!named().empty()) return named().filename().string();
  return live ? endpointsText(*this) : typedText(connect);
}

ContentRequest connectionOf(std::vector<std::string> endpoints, const ContentRequest& shown) {
  ContentRequest request = optionsOf(shown);
  request.cell = shown.cell;
  request.styles = shown.styles;
  request.connect = std::move(endpoints);
  return request;
}

ContentRequest withoutConnection(const ContentRequest& shown, bool forgets) {
  ContentRequest request = optionsOf(shown);
  request.cell = shown.cell;
  if (!shown.cell.empty()) request.styles = shown.styles;
  using Leaving = ContentRequest::Leaving;
  request.leaving = forgets ? Leaving::ends : Leaving::ends_unheard;
  return request;
}

Result<ContentRequest> requestOf(const std::vector<std::filesystem::path>& files,
                                 const ContentRequest& shown) {
  ContentRequest request = optionsOf(shown);
  for (const std::filesystem::path& given : files) {
    const std::filesystem::path file = wholePath(given);
    if (auto there = checkFile(file); !there) return there.error();
    const bool is_log = isLog(file) || isForeignRecording(file);
    std::filesystem::path& place = !is_log               ? request.cell
                                   : request.log.empty() ? request.log
                                                         : request.beside;
    if (!place.empty()) {
      return Error{ErrorKind::bad_argument,
                   "a window shows one cell, one log and one beside it at a time", file.string()};
    }
    place = file;
  }
  if (request.cell.empty() && shown.cell != shown.log) request.fallback_cell = shown.cell;
  if (request.log.empty() && shown.live) request.leaving = ContentRequest::Leaving::goes_along;
  return request;
}

Result<ContentRequest> besideOf(const std::filesystem::path& file, std::string align,
                                const ContentRequest& shown) {
  ContentRequest request = optionsOf(shown);
  request.cell = shown.cell;
  request.log = shown.log;
  request.beside = wholePath(file);
  request.align = std::move(align);
  request.beside_alone = true;
  if (auto there = checkFile(request.beside); !there) return there.error();
  if (!isLog(request.beside) && !isForeignRecording(request.beside)) {
    return Error{ErrorKind::bad_argument, "only a log or another recording can be beside one",
                 request.beside.string()};
  }
  return request;
}

Status readEndpoints(ContentRequest& request) {
  if (request.connect.empty()) return {};
  request.live.emplace();
  for (const std::string& text : request.connect) {
    auto endpoint = Endpoint::parse(text);
    if (!endpoint.ok()) return endpoint.error();
    request.live->push_back(std::move(*endpoint));
  }
  return {};
}

}  // namespace rocinante
