#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "core/base/atomic_file.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/bundle/cell_or_log.h"
#include "core/cli/no_wait.h"
#include "core/cli/opened_session.h"
#include "core/cli/program.h"
#include "core/cli/search_options.h"
#include "core/cli/worker_threads.h"
#include "core/foreign/recordings/cell_and_log.h"
#include "viewer/serve/serve_program.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante serve cell.toml session.mcap\n"
    "  rocinante serve cell.toml --live\n"
    "  rocinante serve cell.toml --live :19960 --listen 0.0.0.0:8080 --token-file secret\n"
    "  rocinante serve cell.toml --live --listen 0.0.0.0:8443 --tls-cert cert.pem --tls-key "
    "key.pem\n"
    "  rocinante serve cell.toml --live --origin https://lichtblick.example\n";

struct Arguments {
  ServeRequest request;
  std::vector<std::string> live, allow;
  std::string listen = "127.0.0.1:8080";
  std::string token_file;
  std::string buffer = "4MB";
  bool no_wait = false;
  bool is_live = false;
  bool quiet = false;
  OpenedRecording opened;  ///< of the log: it lasts as long as it is served
};

Error bad(std::string what, const std::string& where) {
  return {ErrorKind::bad_argument, std::move(what), where};
}

Status readSession(Arguments& arguments) {
  ServeRequest& request = arguments.request;
  orderCellAndLog(request.cell, request.log);
  if (arguments.is_live && !request.log.empty()) {
    return bad("a log and --live cannot be used together", "");
  }
  if (!arguments.is_live && request.log.empty()) {
    if (!isRecording(request.cell)) return bad("give a LOG after the cell, or --live", "");
    request.log = request.cell;
  }
  if (!arguments.is_live) {
    const bool is_alone = request.cell.empty() || request.cell == request.log;
    auto opened =
        cli::openSession(request.log, is_alone ? std::filesystem::path() : request.cell, request);
    if (!opened) return opened.error();
    arguments.opened = std::move(*opened);
    if (is_alone) request.cell = arguments.opened.log;
    request.log = arguments.opened.log;
  }
  if (!arguments.is_live && (!request.trust.empty() || !request.decoders.empty())) {
    return bad("--trust and --decoders are for --live", "");
  }
  for (const std::string& text : arguments.live) {
    if (text.empty()) continue;
    auto endpoint = Endpoint::parse(text);
    if (!endpoint) return endpoint.error();
    request.live.push_back(std::move(*endpoint));
  }
  if (arguments.is_live && request.live.empty()) request.live.push_back(Endpoint::standard());
  cli::applyNoWait(arguments.no_wait, request.live);
  if (!(request.rate_hz >= 1 && request.rate_hz <= 1000)) {
    return bad("--rate is 1 to 1000 a second", fmt::format("{}", request.rate_hz));
  }
  return {};
}

Status readListening(const Arguments& arguments, WebServer::Options& web) {
  const auto endpoint = Endpoint::parse(arguments.listen);
  const bool is_plain = endpoint && endpoint->scheme == Endpoint::Scheme::udp &&
                        !endpoint->isMulticast() && !endpoint->ttl && !endpoint->source &&
                        endpoint->interface.empty() &&
                        arguments.listen.find("://") == std::string::npos;
  if (!is_plain) {
    return bad("--listen takes ADDRESS:PORT: 127.0.0.1:8080, [::1]:8080, 0.0.0.0:8080",
               arguments.listen);
  }
  web.listen = endpoint->address;
  auto allow = AddressFilter::of(arguments.allow);
  if (!allow) return allow.error();
  web.allow = std::move(*allow);
  if (web.certificate.empty() != web.key.empty()) {
    return bad("--tls-cert and --tls-key belong together", "");
  }
  const auto bytes = parseSize(arguments.buffer);
  if (!bytes) return bad(bytes.error().what, "--buffer");
  if (*bytes < 64'000) return bad("--buffer is at least 64kB", arguments.buffer);
  web.client_bytes = *bytes;
  if (web.clients < 1 || web.clients > 10'000) {
    return bad("--clients is 1 to 10000", std::to_string(web.clients));
  }
  return {};
}

Status readToken(const Arguments& arguments, WebServer::Options& web) {
  constexpr std::size_t kLeastToken = 8, kMostToken = 256;
  if (!arguments.token_file.empty()) {
    if (!web.token.empty()) return bad("--token and --token-file are the same twice", "");
    auto text = readFile(arguments.token_file, 4096);
    if (!text) return text.error();
    web.token = text->substr(0, text->find_first_of("\r\n"));
    if (web.token.empty()) return bad("the file of the token is empty", arguments.token_file);
  }
  const bool is_word = web.token.find_first_not_of(
                           "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrst"
                           "uvwxyz0123456789-._~") == std::string::npos;
  if (web.token.empty()) return {};
  if (!is_word || web.token.size() < kLeastToken || web.token.size() > kMostToken) {
    return bad("a token is 8 to 256 letters, digits and -._~", "");
  }
  return {};
}

bool isOpenToAll(const WebServer::Options& web) {
  const auto& address = web.listen.address;
  const bool is_v6_loopback = web.listen.is_ipv6 && web.listen.hostText() == "::1";
  const bool is_loopback = web.listen.is_ipv6 ? is_v6_loopback : address[0] == 127;
  return !is_loopback && web.token.empty() && web.allow.empty();
}

Result<cli::Exit> run(Arguments& arguments) {
  if (Status read = readSession(arguments); !read) return read.error();
  WebServer::Options& web = arguments.request.web;
  if (Status read = readListening(arguments, web); !read) return read.error();
  if (Status read = readToken(arguments, web); !read) return read.error();
  if (isOpenToAll(web) && !arguments.quiet) {
    cli::warn("whoever reaches this address may look: --token, --allow and --tls-cert limit that");
  }
  cli::catchStopSignals();
  arguments.request.parallel = cli::workerThreads();
  ServeSurroundings surroundings;
  surroundings.stop = cli::stopRequested;
  surroundings.notify = [&arguments](std::string_view line) {
    if (!arguments.quiet) std::fprintf(stderr, "%s\n", plainText(line).c_str());
  };
  const auto report = serveUntilStopped(arguments.request, surroundings);
  if (!report) return report.error();
  if (!arguments.quiet) {
    std::string text = countText(report->web.clients, "client");
    if (arguments.is_live) {
      text += fmt::format(", {} received, {} lost", countText(report->received, "datagram"),
                          report->lost);
    }
    if (report->web.skipped > 0) {
      text +=
          fmt::format(", {} skipped for slow clients", countText(report->web.skipped, "message"));
    }
    if (report->web.refused > 0) text += fmt::format(", {} refused", report->web.refused);
    cli::say(text + "\n");
  }
  return report->lost == 0 ? cli::Exit::done : cli::Exit::no;
}

/// Returns --live.
cli::Option declare(cli::CommandLine app, Arguments& arguments) {
  app.addOption("CELL", arguments.request.cell,
                "a .cell.toml, a .urdf, an .obj, or a log that carries its cell")
      .required();
  app.addOption("LOG", arguments.request.log, "the session; without it, that of CELL or --live");
  const cli::Option live =
      app.addOption("--live", arguments.live,
                    "show live packets; EP as in `rocinante record`, default: the local group; "
                    "may be repeated")
          .valueText("EP")
          .mayBeBare();
  app.addOption("--listen", arguments.listen, "where browsers find it; port 0: a free one")
      .valueText("ADDRESS:PORT=127.0.0.1:8080");
  app.addOption("--origin", arguments.request.web.origins,
                "pages of this origin may look too, and this server may be called by its host; "
                "may be repeated")
      .valueText("SCHEME://HOST[:PORT]")
      .oneEach();
  app.addOption("--token", arguments.request.web.token, "ask for this token: /?token=TEXT")
      .valueText("TEXT");
  app.addOption("--token-file", arguments.token_file, "the same from the first line of a file")
      .valueText("FILE");
  app.addOption("--allow", arguments.allow,
                "answer clients in this network only (10.0.0.0/8); may be repeated")
      .valueText("CIDR")
      .oneEach();
  app.addOption("--tls-cert", arguments.request.web.certificate,
                "serve https with this certificate (PEM)")
      .valueText("FILE");
  app.addOption("--tls-key", arguments.request.web.key, "and its key (PEM)").valueText("FILE");
  app.addOption("--clients", arguments.request.web.clients, "live clients at a time, at most")
      .valueText("N=64");
  app.addOption("--buffer", arguments.buffer,
                "what waits for a slow client, at most; beyond it, moments are skipped")
      .valueText("SIZE=4MB");
  app.addOption("--rate", arguments.request.rate_hz,
                "send the values of a device at most HZ times a second")
      .valueText("HZ=60");
  app.addOption("--trust", arguments.request.trust,
                "show only what is signed with a key of this file (rocinante key)")
      .valueText("FILE");
  app.addOption("--decoders", arguments.request.decoders,
                "make packets of what is not packet text as this file declares; without it, as the "
                "cell does")
      .valueText("FILE");
  app.addOption("--viewer", arguments.request.viewer,
                "the folder of rocinante-viewer.js and .wasm, which scripts/build_web makes; "
                "without it, the installed one")
      .valueText("DIR");
  cli::addNoWait(app, arguments.no_wait);
  app.addFlag("--quiet", arguments.quiet, "print nothing but errors");
  cli::addSearchOptions(app, arguments.request);
  return live;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app(
      "Shows a session in any browser: serves the page of `rocinante page` over HTTP, with a log "
      "or\n"
      "with what comes live.",
      "rocinante-serve");
  Arguments arguments;
  const cli::Option live = declare(app, arguments);
  return cli::run(app, argc, argv, kExamples, [&] {
    arguments.is_live = live.given();
    return run(arguments);
  });
}
