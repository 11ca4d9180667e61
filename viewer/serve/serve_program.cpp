#include "viewer/serve/serve_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "core/base/figure_text.h"
#include "core/base/random_id.h"
#include "core/bundle/cell_or_log.h"
#include "core/check/log_account.h"
#include "core/foreign/live/received_decoder.h"
#include "core/log/log_reader.h"
#include "core/report/account.h"
#include "viewer/page/page_file.h"
#include "viewer/page/page_parts.h"
#include "viewer/serve/feed.h"
#include "viewer/serve/live_session.h"

namespace rocinante {
namespace {

/// A log that stays open while it is served.
class OpenLog {
 public:
  static Result<OpenLog> open(const std::filesystem::path& path) {
    std::error_code none;
    const std::uint64_t bytes = std::filesystem::file_size(path, none);
    if (!none && bytes > kMostLogInPageBytes) {
      return Error{ErrorKind::unsupported,
                   fmt::format("the log has {}, and a page in a browser holds at most {}: "
                               "`rocinante log cut` makes a shorter one",
                               sizeText(bytes), sizeText(kMostLogInPageBytes)),
                   path.string()};
    }
    // Read as a log once, so that a page does not have to say what is wrong with it.
    const auto reader = LogReader::open(path);
    if (!reader) return reader.error();
    OpenLog log;
    log.file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (log.file_ < 0 || ::fstat(log.file_, &status) != 0) {
      return Error{ErrorKind::unreadable, std::strerror(errno), path.string()};
    }
    log.size_ = static_cast<std::uint64_t>(status.st_size);
    return log;
  }
  OpenLog() = default;
  OpenLog(OpenLog&& other) noexcept : file_(std::exchange(other.file_, -1)), size_(other.size_) {}
  OpenLog& operator=(OpenLog&& other) noexcept {
    std::swap(file_, other.file_);
    size_ = other.size_;
    return *this;
  }
  ~OpenLog() {
    if (file_ >= 0) ::close(file_);
  }
  int file() const { return file_; }
  std::uint64_t size() const { return size_; }

 private:
  int file_ = -1;
  std::uint64_t size_ = 0;
};

Result<Cell> loadServedCell(const ServeRequest& request, const ServeSurroundings& surroundings) {
  CellOptions options;
  static_cast<ModelSearch&>(options) = request;
  options.parallel = request.parallel;
  auto cell = loadCellOrLog(request.cell, options);
  if (!cell) return cell;
  for (const Finding& fault : cell->faults) {
    surroundings.notify(sentenceOf(fault) + (fault.file.empty() ? "" : " (" + fault.file + ")"));
  }
  return cell;
}

Result<std::string> pageFor(const ServeRequest& request, const Cell& cell) {
  PageParts parts;
  if (Status has = readPageViewer(request.viewer, parts); !has) return has.error();
  parts.cell = pageCell(cell, {}, request.parallel);
  parts.title = (request.log.empty() ? request.cell : request.log).filename().string();
  return servedPageOf(parts, request.log.empty());
}

std::string pageWithoutViewer() {
  return "<!DOCTYPE html><meta charset=\"utf-8\"><title>rocinante serve</title>\n"
         "<p>This server was started without the viewer of pages, which scripts/build_web builds. "
         "Foxglove clients can connect.\n";
}

Result<std::unique_ptr<LiveSession>> listen(const ServeRequest& request, const Cell& cell,
                                            const ServeSurroundings& surroundings,
                                            WebServer& server) {
  Feed::Options options;
  options.endpoints = request.live;
  options.notify = surroundings.notify;
  auto trust = TrustJudge::open(request.trust);
  if (!trust) return trust.error();
  options.trust = std::move(*trust);
  auto decoders = decodersFor(request.decoders.string(), cell);
  if (!decoders) return decoders.error();
  options.decoders = std::move(*decoders);
  auto feed = Feed::start(std::move(options), [&server] { server.wake(); });
  if (!feed) return feed.error();
  LiveHub::Options hub;
  hub.run = randomId(5);
  hub.name = "serve-" + hub.run;
  hub.rate_hz = request.rate_hz;
  return std::make_unique<LiveSession>(std::move(*feed), std::move(hub), cell);
}

std::string addressText(const ServeRequest& request, std::uint16_t port) {
  SocketAddress shown = request.web.listen;
  shown.port = port;
  return fmt::format("{}://{}/{}", request.web.certificate.empty() ? "http" : "https", shown.text(),
                     request.web.token.empty() ? "" : "?token=...");
}

}  // namespace

Result<ServeReport> serveUntilStopped(const ServeRequest& request,
                                      const ServeSurroundings& surroundings) {
  const auto cell = loadServedCell(request, surroundings);
  if (!cell) return cell.error();
  WebContent content;
  OpenLog log;
  if (!request.log.empty()) {
    auto opened = OpenLog::open(request.log);
    if (!opened) return opened.error();
    log = std::move(*opened);
    content.log = log.file();
    content.log_bytes = log.size();
    const auto account = logAccount(request.log, &*cell);
    const std::string note = account ? account->note() : std::string();
    if (!note.empty()) surroundings.notify(note);
  }
  auto page = pageFor(request, *cell);
  // Foxglove clients of a live session need no page; whoever named a viewer wants one.
  const bool is_dispensable = request.log.empty() && request.viewer.empty();
  if (!page && (!is_dispensable || page.error().kind != ErrorKind::not_found)) return page.error();
  if (!page) surroundings.notify("no page, Foxglove clients alone: " + page.error().what);
  content.page = page ? std::move(*page) : pageWithoutViewer();
  WebServer::Options web = request.web;
  web.notify = surroundings.notify;
  auto server = WebServer::open(std::move(web), std::move(content));
  if (!server) return server.error();
  std::unique_ptr<LiveSession> live;
  std::string shown = request.log.filename().string();
  if (request.log.empty()) {
    auto listening = listen(request, *cell, surroundings, **server);
    if (!listening) return listening.error();
    live = std::move(*listening);
    for (const std::string& each : live->feed().listening()) {
      shown += (shown.empty() ? "live from " : ", ") + each;
    }
  }
  surroundings.notify(
      fmt::format("serving {} at {}", shown, addressText(request, (*server)->port())));
  if (Status ran = (*server)->run(live.get(), surroundings.stop); !ran) return ran.error();
  ServeReport report;
  report.web = (*server)->counts();
  if (live) {
    report.received = live->feed().received();
    report.lost = live->feed().dropped();
  }
  return report;
}

}  // namespace rocinante
