#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/base/random_id.h"
#include "core/cli/no_wait.h"
#include "core/cli/program.h"
#include "core/report/json_text.h"
#include "player/relay/relay_program.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante relay --serve :19961                    the local group, to who subscribes\n"
    "  rocinante relay --from :19960 --to 10.0.0.7:19960 --to 239.1.2.3:5000?interface=eth0\n"
    "  rocinante relay --from :19960 --to 10.0.0.7:19960 --device 'arm*' --max-rate 10\n"
    "  rocinante relay --from :19960 --to 10.0.0.7:19960 --bandwidth 28.8k,overhead=8\n"
    "  rocinante relay --serve :19961 --statement signal --signal 'arm *'\n"
    "  rocinante relay --from :49152 --to 239.1.2.3:5000 --decoders kuka.decoders.toml\n"
    "  rocinante relay --serve :19961 --allow 10.0.0.0/8 --statement joints,pose\n";

struct Arguments {
  std::vector<std::string> from, to, serve, allow;
  std::vector<std::string> sources, devices, signals, statements, min_change;
  std::string name, max_rate, bandwidth, trust, key, decoders;
  std::string restate = "2s";
  std::string realtime = "auto";
  bool no_wait = false;
  bool json = false;
  bool quiet = false;
};

void declare(cli::CommandLine app, Arguments& arguments) {
  app.addOption("--from", arguments.from,
                "listen here; may be repeated; default " + Endpoint::standard().text())
      .valueText("EP")
      .oneEach();
  app.addOption("--to", arguments.to, "send here; may be repeated").valueText("EP").oneEach();
  app.addOption("--serve", arguments.serve, "answer subscriptions here; may be repeated")
      .valueText("EP")
      .oneEach();
  cli::addNoWait(app, arguments.no_wait);
  app.addOption("--name", arguments.name,
                "NAME of this relay, unique at a site; default the host's and eight digits")
      .valueText("NAME");
  app.addOption("--source", arguments.sources, "pass these SOURCEs only (pattern); may be repeated")
      .valueText("PATTERN")
      .oneEach();
  app.addOption("--device", arguments.devices,
                "of devices, pass statements about these only (pattern); may be repeated")
      .valueText("PATTERN")
      .oneEach();
  app.addOption("--signal", arguments.signals,
                "of signals, pass these only (pattern of PATH NAME: 'arm *.effort', '- estop');\n"
                "may be repeated")
      .valueText("PATTERN")
      .oneEach();
  app.addOption("--statement", arguments.statements, "pass these statements only: joints,pose")
      .separatedBy(',')
      .valueText("KIND,...");
  app.addOption("--min-change", arguments.min_change,
                "hold smaller changes until a device rests: joint=0.001,position=0.001,turn=0.01\n"
                "(radians or metres; metres; radians); of numbers of signals until a larger one\n"
                "comes: signal=0.5 or 'signal arm *.effort=0.5'")
      .separatedBy(',')
      .valueText("WHAT=X,...");
  app.addOption("--max-rate", arguments.max_rate,
                "send the values of a device at most HZ times a second")
      .valueText("HZ");
  app.addOption(
         "--bandwidth", arguments.bandwidth,
         "send at most this many bits a second to each output: 28.8k, 2M; overhead=N: bytes\n"
         "that the link adds to each datagram (PPP 8, Ethernet 14)")
      .valueText("RATE[,overhead=N]");
  app.addOption("--restate", arguments.restate, "filtered outputs restate everything this often")
      .valueText("TIME=2s");
  app.addOption("--allow", arguments.allow,
                "accept senders and subscribers in this network only (10.0.0.0/8); may be repeated")
      .valueText("CIDR")
      .oneEach();
  app.addOption("--trust", arguments.trust,
                "pass only what is signed with a key of this file (rocinante key)")
      .valueText("FILE");
  app.addOption("--decoders", arguments.decoders,
                "make packets of what is not packet text as this file declares, and pass them")
      .valueText("FILE");
  app.addOption("--key", arguments.key, "sign with this secret key what the relay writes itself")
      .valueText("FILE");
  app.addOption("--realtime", arguments.realtime, "run before other threads: auto, on or off")
      .oneOf({"auto", "on", "off"})
      .valueText("WHEN=auto");
  app.addFlag("--json", arguments.json, "print what was relayed as JSON");
  app.addFlag("--quiet", arguments.quiet, "print nothing but errors (and --json)");
}

Error bad(std::string what, const std::string& where) {
  return {ErrorKind::bad_argument, std::move(what), where};
}

/// A positive number and what follows it.
Result<double> positive(const std::string& text, std::string& rest, const char* option) {
  double value = 0;
  int used = 0;
  const bool plain = text.find_first_not_of("0123456789.kKmMgG") == std::string::npos;
  if (!plain || std::sscanf(text.c_str(), "%lf%n", &value, &used) != 1 || !(value > 0) ||
      !std::isfinite(value)) {
    return bad(fmt::format("{} needs a number greater than zero", option), text);
  }
  rest = text.substr(static_cast<std::size_t>(used));
  return value;
}

Result<double> bytesPerSecond(const std::string& text) {
  std::string unit;
  const Result<double> number = positive(text, unit, "--bandwidth");
  if (!number) return number.error();
  const double factor = unit.empty()  ? 1
                        : unit == "k" ? 1e3
                        : unit == "M" ? 1e6
                        : unit == "G" ? 1e9
                                      : 0;
  if (factor == 0) return bad("--bandwidth takes k, M or G behind its number of bits", text);
  const double bits = *number * factor;
  if (bits < 1200) return bad("--bandwidth is at least 1200 bits a second", text);
  return bits / 8;
}

/// RATE[,overhead=N]
Status readBandwidth(const std::string& text, RelayOutputOptions& outputs) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const Result<double> bytes = bytesPerSecond(text.substr(0, comma));
  if (!bytes) return bytes.error();
  outputs.bytes_per_second = *bytes;
  if (comma == text.size()) return {};
  constexpr std::string_view kOverhead = "overhead=";
  const std::string_view option = std::string_view(text).substr(comma + 1);
  const std::string_view digits = option.substr(std::min(kOverhead.size(), option.size()));
  std::size_t count = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (!option.starts_with(kOverhead) || fault != std::errc() ||
      end != digits.data() + digits.size() || count > 1000) {
    return bad("behind its rate --bandwidth takes overhead=N, 0 to 1000 bytes a datagram", text);
  }
  outputs.link_bytes = count;
  return {};
}

Status readMinChange(const std::vector<std::string>& texts, MinChange& least) {
  for (const std::string& text : texts) {
    const Status added = least.add(text);
    if (!added) return bad("--min-change " + added.error().what, text);
  }
  return {};
}

Status readOutputs(const Arguments& arguments, RelayOutputOptions& outputs) {
  RelayFilter filter;
  filter.sources = arguments.sources;
  filter.devices = arguments.devices;
  filter.signals = arguments.signals;
  if (!arguments.statements.empty()) filter.kinds = 0;
  for (const std::string& each : arguments.statements) {
    const Result<std::uint32_t> kinds = statementKindsOf(each);
    if (!kinds) return kinds.error();
    filter.kinds |= *kinds;
  }
  if (!filter.passesEverything()) outputs.filters.push_back(std::move(filter));
  if (Status read = readMinChange(arguments.min_change, outputs.pacing.min_change); !read)
    return read;
  if (!arguments.max_rate.empty()) {
    std::string rest;
    const Result<double> hz = positive(arguments.max_rate, rest, "--max-rate");
    if (!hz) return hz.error();
    if (!rest.empty() || *hz < 0.001) {
      return bad("--max-rate takes a plain number of at least 0.001", arguments.max_rate);
    }
    outputs.pacing.interval = Nanoseconds(static_cast<std::int64_t>(1e9 / *hz));
  }
  if (!arguments.bandwidth.empty()) {
    if (Status read = readBandwidth(arguments.bandwidth, outputs); !read) return read;
  }
  return {};
}

Status readEndpoints(const std::vector<std::string>& texts, std::vector<Endpoint>& endpoints) {
  for (const std::string& text : texts) {
    Result<Endpoint> endpoint = Endpoint::parse(text);
    if (!endpoint) return endpoint.error();
    endpoints.push_back(std::move(*endpoint));
  }
  return {};
}

std::string defaultName() {
  std::array<char, 200> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0 || host[0] == 0) return randomId(4);
  return std::string(host.data()) + "-" + randomId(4);
}

Result<RelayProgramOptions> readOptions(const Arguments& arguments) {
  RelayProgramOptions options;
  if (arguments.to.empty() && arguments.serve.empty()) {
    return bad("nowhere to relay to: give --to EP or --serve EP", "");
  }
  if (Status read = readEndpoints(arguments.from, options.from); !read) return read.error();
  if (Status read = readEndpoints(arguments.to, options.to); !read) return read.error();
  if (Status read = readEndpoints(arguments.serve, options.serve); !read) return read.error();
  if (options.from.empty()) options.from.push_back(Endpoint::standard());
  cli::applyNoWait(arguments.no_wait, options.from);
  cli::applyNoWait(arguments.no_wait, options.to);
  if (Status read = readOutputs(arguments, options.outputs); !read) return read.error();
  const Result<AddressFilter> allow = AddressFilter::of(arguments.allow);
  if (!allow) return allow.error();
  options.allow = *allow;
  const Result<Nanoseconds> restate = parseDuration(arguments.restate);
  if (!restate) return restate.error();
  if (*restate < std::chrono::milliseconds(100) || *restate > std::chrono::hours(1)) {
    return bad("--restate is 100ms to 1h", arguments.restate);
  }
  options.restate = *restate;
  options.name = arguments.name.empty() ? defaultName() : arguments.name;
  const bool named = options.name.size() <= 200 && options.name.find(':') == std::string::npos &&
                     options.name == plainText(options.name);
  if (!named) return bad("--name is at most 200 bytes of text without a colon", options.name);
  options.run = randomId(5);
  if (!arguments.decoders.empty()) {
    auto decoders = decode::readDecoders(arguments.decoders);
    if (!decoders) return decoders.error();
    options.decoders = std::move(*decoders);
  }
  options.trust = arguments.trust;
  options.key = arguments.key;
  options.realtime = realtimeOf(arguments.realtime);
  options.progress = !arguments.quiet && ::isatty(STDERR_FILENO) == 1;
  return options;
}

Result<cli::Exit> run(const Arguments& arguments) {
  const Result<RelayProgramOptions> options = readOptions(arguments);
  if (!options) return options.error();
  cli::catchStopSignals();
  SendSurroundings surroundings;
  surroundings.stop = cli::stopRequested;
  surroundings.notify = [&arguments](std::string_view line) {
    if (!arguments.quiet) std::fprintf(stderr, "%s\n", plainText(line).c_str());
  };
  const Result<RelayReport> report = relayUntilStopped(*options, surroundings);
  if (!report) return report.error();
  if (arguments.json) {
    cli::say(jsonText(*report));
  } else if (!arguments.quiet) {
    cli::say(summaryText(*report));
  }
  return report->lost() == 0 ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app(
      "Forwards packets of several sources to addresses and subscribers, whole or filtered, and\n"
      "greets late joiners with the present state.",
      "rocinante-relay");
  Arguments arguments;
  declare(app, arguments);
  return cli::run(app, argc, argv, kExamples, [&] { return run(arguments); });
}
