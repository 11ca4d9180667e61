#include "viewer/ui/study/endpoint_survey.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/net/udp_socket.h"
#include "core/packet/decoder.h"
#include "core/transport/open_source.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr int kEarPollMs = 50;
constexpr std::size_t kSourcesNamed = 3;
/// One endpoint under a flood must not keep the others waiting, nor its own end.
constexpr int kEarBatches = 16;

/// One of them while it is open.
class Ear {
 public:
  explicit Ear(const SurveyedEndpoint& wanted) : length_(wanted.length) {
    heard_.endpoint = wanted.endpoint.text();
    auto opened = openSource(wanted.endpoint);
    if (opened.ok()) {
      source_ = std::move(*opened);
    } else {
      heard_.fault = plainText(faultInWindow(opened.error().what));
      heard_.listening = false;
    }
  }

  bool isOpen() const { return source_ != nullptr; }
  int fileDescriptor() const { return source_->fileDescriptor(); }
  /// Takes what waits; true when something came.
  bool drain(Decoder& decoder) {
    const std::uint64_t before = heard_.datagrams;
    for (int turn = 0; turn < kEarBatches; ++turn) {
      const auto batch = source_->receive();
      if (!batch.ok() || batch->empty()) break;
      for (const ReceivedDatagram& datagram : *batch) take(datagram, decoder);
    }
    return heard_.datagrams > before;
  }
  /// True when it was just closed.
  bool closeAfter(Nanoseconds since_begin) {
    if (since_begin < length_) return false;
    source_.reset();
    heard_.listening = false;
    return true;
  }
  const HeardEndpoint& heard() {
    heard_.sources.assign(names_.begin(), names_.end());
    return heard_;
  }

 private:
  void take(const ReceivedDatagram& datagram, Decoder& decoder) {
    ++heard_.datagrams;
    const Packet* const packet = decoder.decode(datagram.payload);
    if (packet == nullptr) {
      ++heard_.undecoded;
    } else if (names_.size() < HeardEndpoint::kMostSources) {
      names_.insert(plainText(packet->header.source));
    }
  }

  Nanoseconds length_;
  std::unique_ptr<DatagramSource> source_;
  std::set<std::string> names_;
  HeardEndpoint heard_;
};

std::vector<HeardEndpoint> heardOf(std::vector<Ear>& ears) {
  std::vector<HeardEndpoint> all;
  for (Ear& ear : ears) all.push_back(ear.heard());
  return all;
}

}  // namespace

std::string faultInWindow(std::string fault) {
  if (const std::size_t at = fault.find(kTakenPortAdvice); at != fault.npos) {
    fault.replace(
        at, kTakenPortAdvice.size(),
        "`connect` to a group, to a relay (subscribe://HOST:PORT) or to pcap://INTERFACE");
  }
  return fault;
}

std::string HeardEndpoint::text() const {
  if (!fault.empty()) return fault;
  if (datagrams == 0) return listening ? "listening ..." : "nothing heard";
  std::string names;
  for (std::size_t i = 0; i < std::min(sources.size(), kSourcesNamed); ++i) {
    names += (i > 0 ? ", " : "") + sources[i];
  }
  if (sources.size() > kSourcesNamed) {
    names += fmt::format(" and {} more", sources.size() - kSourcesNamed);
  }
  if (names.empty()) return countText(undecoded, "datagram") + " that are no packets";
  return names + ": " + countText(datagrams - undecoded, "packet");
}

std::vector<SurveyedEndpoint> usualEndpoints() {
  // Sources restate every two seconds.
  SurveyedEndpoint group{Endpoint::standard(), 2200ms};
  SurveyedEndpoint port{{}, 1200ms};
  port.endpoint.address.port = group.endpoint.address.port;
  return {std::move(group), std::move(port)};
}

EndpointSurvey::EndpointSurvey(std::vector<SurveyedEndpoint> endpoints)
    : endpoints_(std::move(endpoints)),
      worker_([this](const Question&, const std::stop_token& stop) { return look(stop); }) {
  listen();
}

void EndpointSurvey::listen() { worker_.ask({}); }

std::vector<HeardEndpoint> EndpointSurvey::heard() const {
  const auto found = worker_.found();
  return found ? *found : Answer();
}

EndpointSurvey::Answer EndpointSurvey::look(const std::stop_token& stop) {
  const auto decoder = makeDecoder("rk1");
  std::vector<Ear> ears;
  ears.reserve(endpoints_.size());
  for (const SurveyedEndpoint& wanted : endpoints_) ears.emplace_back(wanted);
  const SteadyTime began = std::chrono::steady_clock::now();
  worker_.publish(heardOf(ears));
  while (!stop.stop_requested()) {
    std::vector<pollfd> polls;
    for (const Ear& ear : ears) {
      if (ear.isOpen()) polls.push_back({ear.fileDescriptor(), POLLIN, 0});
    }
    if (polls.empty()) break;
    ::poll(polls.data(), polls.size(), kEarPollMs);
    bool changed = false;
    const Nanoseconds since_begin = SteadyTime(std::chrono::steady_clock::now()) - began;
    for (Ear& ear : ears) {
      if (!ear.isOpen()) continue;
      changed = ear.drain(*decoder) || changed;
      changed = ear.closeAfter(since_begin) || changed;
    }
    if (changed) worker_.publish(heardOf(ears));
  }
  return heardOf(ears);
}

}  // namespace rocinante
