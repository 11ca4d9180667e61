#include "tests/bench/replay/replay_schedule.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <fstream>
#include <random>

#include "core/log/log_writer.h"

namespace rocinante::bench {
namespace {

// Any moment will do, if the recordings agree.
constexpr std::int64_t kEpochUs = 1'700'000'000'000'000;

Nanoseconds wholeMicroseconds(double seconds) {
  return std::chrono::microseconds(static_cast<std::int64_t>(seconds * 1e6));
}

template <class Number>
void addBigEndian(std::string& to, Number number) {
  for (int shift = static_cast<int>(sizeof number) * 8 - 8; shift >= 0; shift -= 8) {
    to += static_cast<char>((static_cast<std::uint64_t>(number) >> shift) & 0xFFU);
  }
}

template <class Number>
void addNative(std::string& to, Number number) {
  to.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::uint16_t internetChecksum(std::string_view header) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i + 1 < header.size(); i += 2) {
    sum += (static_cast<std::uint32_t>(static_cast<unsigned char>(header[i])) << 8U) |
           static_cast<unsigned char>(header[i + 1]);
  }
  while (sum > 0xFFFFU) sum = (sum & 0xFFFFU) + (sum >> 16U);
  return static_cast<std::uint16_t>(~sum);
}

void addAddress(std::string& to, const SocketAddress& address) {
  to.append(reinterpret_cast<const char*>(address.address.data()), 4);
}

std::string frameOf(const SocketAddress& from, const SocketAddress& to, std::string_view payload) {
  std::string frame;
  // RFC 1112, 6.4: the low 23 bits of the group.
  frame += std::string("\x01\x00\x5e", 3);
  frame += static_cast<char>(to.address[1] & 0x7FU);
  frame.append(reinterpret_cast<const char*>(to.address.data()) + 2, 2);
  frame += std::string("\x02\x00\x00\x00\x00\x01\x08\x00", 8);

  std::string ip;
  ip += std::string("\x45\x00", 2);
  addBigEndian(ip, static_cast<std::uint16_t>(20 + 8 + payload.size()));
  ip += std::string("\x00\x00\x40\x00\x01\x11\x00\x00", 8);  // TTL 1, UDP
  addAddress(ip, from);
  addAddress(ip, to);
  const std::uint16_t checksum = internetChecksum(ip);
  ip[10] = static_cast<char>(checksum >> 8U);
  ip[11] = static_cast<char>(checksum & 0xFFU);
  frame += ip;

  addBigEndian(frame, from.port);
  addBigEndian(frame, to.port);
  addBigEndian(frame, static_cast<std::uint16_t>(8 + payload.size()));
  addBigEndian(frame, std::uint16_t{0});  // no checksum
  frame += payload;
  return frame;
}

std::int64_t microsecondsOf(Nanoseconds due) { return kEpochUs + due.count() / 1000; }

}  // namespace

Schedule Schedule::regular(double rate_hz, std::size_t count) {
  Schedule schedule;
  for (std::size_t i = 0; i < count; ++i) {
    schedule.due.push_back(wholeMicroseconds(static_cast<double>(i) / rate_hz));
  }
  return schedule;
}

Schedule Schedule::poisson(double rate_hz, std::size_t count) {
  std::mt19937_64 random(1996);
  std::exponential_distribution<double> gap(rate_hz);
  Schedule schedule;
  double moment = 0;
  for (std::size_t i = 0; i < count; ++i) {
    schedule.due.push_back(wholeMicroseconds(moment));
    moment += gap(random);
  }
  return schedule;
}

std::string payloadOf(std::size_t number) {
  const double q = static_cast<double>(number % 100'000) * 1e-5;
  std::string text = fmt::format("RK1 arm@r1 {} -\njoints arm {:.4f} {:.4f} {:.4f} {:.4f} 0 {:.4f}",
                                 number, q, q / 2, 1 - q, q * q, q / 3);
  text.resize(90, ' ');
  return text + fmt::format("\n#{:08}", number);
}

std::int64_t numberOf(ByteView datagram) {
  const std::string_view text = textOf(datagram);
  if (text.size() < 10 || text.substr(text.size() - 10, 2) != "\n#") return -1;
  std::int64_t number = -1;
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(end - 8, end, number);
  return fault == std::errc() && stop == end ? number : -1;
}

Status writeMcap(const std::filesystem::path& path, const Schedule& schedule) {
  LogWriterOptions options;
  options.overwrite = true;
  Result<LogWriter> log = LogWriter::create(path, options, "bench");
  if (!log) return log.error();
  const Result<ChannelId> channel =
      log->addChannel("/udp/7667/arm", "rk1", {{"source", "arm"}, {"protocol", "udp"}});
  if (!channel) return channel.error();
  for (std::size_t i = 0; i < schedule.due.size(); ++i) {
    const std::int64_t at = microsecondsOf(schedule.due[i]) * 1000;
    const Status written = log->write(*channel, static_cast<std::uint32_t>(i),
                                      LogTime(Nanoseconds(at)), at, bytesOf(payloadOf(i)));
    if (!written) return written;
  }
  return log->close("bench");
}

void writePcap(const std::filesystem::path& path, const Schedule& schedule,
               const SocketAddress& from, const SocketAddress& to) {
  std::ofstream file(path, std::ios::binary);
  std::string text;
  addNative(text, std::uint32_t{0xA1B2C3D4});
  addNative(text, std::uint16_t{2});
  addNative(text, std::uint16_t{4});
  addNative(text, std::uint64_t{0});
  addNative(text, std::uint32_t{65'535});
  addNative(text, std::uint32_t{1});  // Ethernet
  for (std::size_t i = 0; i < schedule.due.size(); ++i) {
    const std::string frame = frameOf(from, to, payloadOf(i));
    const std::int64_t at = microsecondsOf(schedule.due[i]);
    addNative(text, static_cast<std::uint32_t>(at / 1'000'000));
    addNative(text, static_cast<std::uint32_t>(at % 1'000'000));
    addNative(text, static_cast<std::uint32_t>(frame.size()));
    addNative(text, static_cast<std::uint32_t>(frame.size()));
    text += frame;
  }
  file << text;
}

void writeLcm(const std::filesystem::path& path, const Schedule& schedule) {
  std::ofstream file(path, std::ios::binary);
  std::string text;
  const std::string channel = "arm";
  for (std::size_t i = 0; i < schedule.due.size(); ++i) {
    const std::string payload = payloadOf(i);
    addBigEndian(text, std::uint32_t{0xEDA1DA01});
    addBigEndian(text, static_cast<std::uint64_t>(i));
    addBigEndian(text, microsecondsOf(schedule.due[i]));
    addBigEndian(text, static_cast<std::uint32_t>(channel.size()));
    addBigEndian(text, static_cast<std::uint32_t>(payload.size()));
    text += channel + payload;
  }
  file << text;
}

}  // namespace rocinante::bench
