#include "player/demo/demo_speaker.h"

#include <fmt/core.h>

#include <span>
#include <utility>

#include "core/packet/restatement.h"

namespace rocinante {

DemoSpeaker::DemoSpeaker(DemoPart part, const DemoOptions& options, std::uint64_t first_sequence)
    : part_(part), options_(options), sequence_(first_sequence) {}

void DemoSpeaker::say(Nanoseconds at, const std::vector<Statement>& statements) {
  PacketTextWriter packet(header(at));
  bool empty = true;
  for (const Statement& statement : statements) {
    const std::size_t line_bytes = statementText(statement).size() + 1;
    if (!empty && packet.byteCount() + line_bytes > options_.mtu_bytes) {
      send(at, packet.text());
      packet = PacketTextWriter(header(at));
    }
    packet.add(statement);
    empty = false;
  }
  if (!empty) {
    send(at, packet.text());
  }
}

void DemoSpeaker::sayAgain(Nanoseconds at) {
  RestatementOptions options;
  const std::string part_id = fmt::format("r{}", restatements_++);
  options.part_id = part_id;
  // The parts have the last datagram's header. Ours may be longer: by `restated`, by a digit of
  // SEQUENCE, by the decimals of TIME.
  options.mtu_bytes = options_.mtu_bytes - 32;
  const std::vector<std::string> parts = restate(state_, nameOf(part_), options);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    PacketHeader again = header(at);
    again.restated = true;
    again.part = RestatementPart{part_id, static_cast<std::uint32_t>(i + 1),
                                 static_cast<std::uint32_t>(parts.size())};
    const std::size_t body = parts[i].find('\n');
    std::string payload = headerText(again) + '\n';
    if (body != std::string::npos) {
      payload.append(parts[i], body + 1);
    }
    send(at, std::move(payload));
  }
}

PacketHeader DemoSpeaker::header(Nanoseconds at) const {
  PacketHeader header;
  header.source = nameOf(part_);
  header.run = options_.run;
  header.sequence = sequence_;
  header.time_ns = options_.epoch_ns + at.count();
  return header;
}

void DemoSpeaker::send(Nanoseconds at, std::string payload) {
  if (const Packet* packet = decoder_.decode(std::as_bytes(std::span(payload)))) {
    state_.apply(LogTime(at), *packet);
  }
  ++sequence_;
  datagrams_.push_back(DemoDatagram{at, part_, std::move(payload)});
}

}  // namespace rocinante
