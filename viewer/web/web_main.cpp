// What a page calls (viewer/page/page.js). Text goes out as UTF-8 that is valid until the next
// call; times are nanoseconds from the session's origin, which a JavaScript number holds exactly
// for a hundred days.

#include <emscripten.h>

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/version.h"
#include "core/report/json_text.h"
#include "viewer/web/web_fold.h"
#include "viewer/web/web_session.h"

namespace {

using namespace rocinante;

std::optional<WebSession> session;
WebLog page_log;  // opened again when its beginning was not enough
std::string answer;

const char* say(std::string text) {
  answer = std::move(text);
  return answer.c_str();
}
const char* say(const Status& status) { return say(status ? "" : status.error().text()); }
/// JSON, or an object whose `error` says why there is none.
const char* say(const Result<std::string>& json) {
  if (json) return say(*json);
  return say(
      Json{{"error", json.error().text()}}.dump(-1, ' ', false, Json::error_handler_t::replace));
}

Bytes bytesAt(const std::uint8_t* at, std::size_t size) {
  const auto* const first = reinterpret_cast<const std::byte*>(at);
  return Bytes(first, first + size);
}

std::int64_t ns(double given) { return static_cast<std::int64_t>(given); }

}  // namespace

extern "C" {

/// Takes over `log`, which malloc() gave and the page still fills: of `log_size` bytes `there` are
/// there. Empty, or what is wrong.
EMSCRIPTEN_KEEPALIVE const char* rocinante_open(const std::uint8_t* cell, std::size_t cell_size,
                                                std::uint8_t* log, std::size_t log_size,
                                                std::size_t there) {
  session.reset();
  auto* const bytes = reinterpret_cast<std::byte*>(log);
  if (page_log.whole().data() != bytes) page_log = WebLog(bytes, log_size);
  auto opened = WebSession::open(bytesAt(cell, cell_size), page_log, there);
  if (!opened) return say(opened.error().text());
  session.emplace(std::move(*opened));
  return say(std::string());
}
/// The whole log is there now. Empty, or what is wrong.
EMSCRIPTEN_KEEPALIVE const char* rocinante_open_whole() { return say(session->openWhole()); }

/// The same for a live session, which rocinante_take() feeds.
EMSCRIPTEN_KEEPALIVE const char* rocinante_open_live(const std::uint8_t* cell,
                                                     std::size_t cell_size) {
  session.reset();
  auto opened = WebSession::openLive(bytesAt(cell, cell_size));
  if (!opened) return say(opened.error().text());
  session.emplace(std::move(*opened));
  return say(std::string());
}

// The others require an open session.

/// A message of the server of a live session. Empty, or what is wrong.
EMSCRIPTEN_KEEPALIVE const char* rocinante_take(const std::uint8_t* at, std::size_t size) {
  return say(session->live()->take({reinterpret_cast<const std::byte*>(at), size}));
}
/// The time of the newest one, from the first.
EMSCRIPTEN_KEEPALIVE double rocinante_live_ns() {
  const WebLive& live = *session->live();
  return static_cast<double>((live.time() - live.origin()).count());
}

EMSCRIPTEN_KEEPALIVE const char* rocinante_about() { return say(session->aboutJson()); }
EMSCRIPTEN_KEEPALIVE const char* rocinante_events() { return say(session->eventsJson()); }
EMSCRIPTEN_KEEPALIVE const char* rocinante_devices(double at) {
  return say(session->devicesJson(ns(at)));
}
EMSCRIPTEN_KEEPALIVE const char* rocinante_poses(double at) {
  return say(session->posesJson(ns(at)));
}
/// `care`: 0 whole, 1 moving, 2 first.
EMSCRIPTEN_KEEPALIVE const char* rocinante_draw(double at, int width, int height, double scale,
                                                int care) {
  return say(session->draw(ns(at), width, height, scale, static_cast<WebSession::Care>(care % 3)));
}
/// 0 when nothing is left to make.
EMSCRIPTEN_KEEPALIVE int rocinante_make_detail() { return session->makeNextDetail() ? 1 : 0; }
/// The same.
EMSCRIPTEN_KEEPALIVE int rocinante_next_picture() { return session->readNextPicture() ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE void rocinante_frame_took(double ms) { session->frameTook(ms); }
EMSCRIPTEN_KEEPALIVE int rocinante_rung() { return session->rung(); }
EMSCRIPTEN_KEEPALIVE const char* rocinante_pick(double at, double x, double y, int width,
                                                int height) {
  return say(session->pickJson(ns(at), x, y, width, height));
}
EMSCRIPTEN_KEEPALIVE const char* rocinante_select(const char* path) {
  return say(session->select(path));
}
/// The part that is read, or -1 when the log cannot be read on.
EMSCRIPTEN_KEEPALIVE double rocinante_read_plots(int messages) {
  const auto part = session->readPlots(static_cast<std::uint64_t>(messages));
  return part ? *part : -1.0;
}
EMSCRIPTEN_KEEPALIVE const char* rocinante_plots(const char* device, double at, int width,
                                                 double height) {
  return say(session->plotsJson(device, ns(at), static_cast<std::size_t>(width), height));
}
/// Before the first rocinante_read_plots(). Empty, or what is wrong.
EMSCRIPTEN_KEEPALIVE const char* rocinante_choose_plot(const char* name) {
  return say(session->choosePlot(name));
}
EMSCRIPTEN_KEEPALIVE const char* rocinante_chosen(double at) {
  return say(session->chosenJson(ns(at)));
}
EMSCRIPTEN_KEEPALIVE void rocinante_clear_insets() { session->clearInsets(); }
EMSCRIPTEN_KEEPALIVE const char* rocinante_add_inset(const char* text) {
  return say(session->addInset(text));
}
EMSCRIPTEN_KEEPALIVE const char* rocinante_use_camera(const char* name) {
  return say(session->useCamera(name));
}
EMSCRIPTEN_KEEPALIVE const char* rocinante_orbit(double at, double dx, double dy, int width,
                                                 int height) {
  return say(session->orbit(ns(at), dx, dy, width, height));
}
EMSCRIPTEN_KEEPALIVE const char* rocinante_pan(double at, double dx, double dy, int width,
                                               int height) {
  return say(session->pan(ns(at), dx, dy, width, height));
}
EMSCRIPTEN_KEEPALIVE const char* rocinante_zoom(double at, double steps, double right, double down,
                                                int width, int height) {
  return say(session->zoomAt(ns(at), steps, right, down, width, height));
}
/// Whether the camera in use depends on the whole session.
EMSCRIPTEN_KEEPALIVE int rocinante_is_fitted() { return session->isFitted() ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE const char* rocinante_camera() { return say(session->camera()); }
EMSCRIPTEN_KEEPALIVE const char* rocinante_warning() { return say(session->warning()); }
/// JSON: what folding this log gave. Of any log, for whoever measures.
EMSCRIPTEN_KEEPALIVE const char* rocinante_fold(const std::uint8_t* log, std::size_t size) {
  const auto whole = foldWhole({reinterpret_cast<const std::byte*>(log), size});
  if (!whole) return say(Result<std::string>(whole.error()));
  return say(
      Json{{"messages", whole->messages}, {"applied", whole->applied}, {"state", whole->state}}
          .dump());
}
EMSCRIPTEN_KEEPALIVE const char* rocinante_version() { return say(std::string(version())); }
}
