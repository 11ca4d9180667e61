// The cost of a Source, beside loops that only format the same values: a six-joint arm that moves
// every cycle, and 10,000 devices of which 0.1, 10 and 100 % move. Then a controller's loop of
// 1 kHz with and without sending over loopback: processor time of the thread, each cycle.
// usage: source_bench [--seconds N]     of each controller's loop; 3 by default
#include <time.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/net/udp_socket.h"
#include "core/source/source.h"

#define RK_SOURCE_STATIC
#define RK_SOURCE_IMPLEMENTATION
#include "core/source/rocinante/rocinante_source.h"

namespace {

using namespace rocinante;

constexpr std::size_t kJoints = 6;
using Joints = std::array<double, kJoints>;

/// Values as a controller has them: every digit of a double.
Joints jointsAt(std::size_t cycle, std::size_t device) {
  Joints joints{};
  const double phase = 0.001 * static_cast<double>(cycle) + 0.1 * static_cast<double>(device);
  for (std::size_t i = 0; i < kJoints; ++i) {
    joints[i] = 3.0 * std::sin(phase * (1.0 + 0.1 * static_cast<double>(i)));
  }
  return joints;
}

double threadNanoseconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// Processor time of each work, in nanoseconds: the best of many turns taken one after the other,
/// so that a busy machine meets all of them alike.
template <class... Works>
std::array<double, sizeof...(Works)> bestOf(Works... works) {
  std::array<double, sizeof...(Works)> best{};
  best.fill(1e18);
  for (int turn = 0; turn < 15; ++turn) {
    std::size_t at = 0;
    const auto run = [&](auto& work) {
      const double begin = threadNanoseconds();
      work();
      best[at] = std::min(best[at], threadNanoseconds() - begin);
      ++at;
    };
    (run(works), ...);
  }
  return best;
}

std::size_t g_bytes = 0;

bool sendNowhere(std::span<std::byte> datagram) {
  g_bytes += datagram.size();
  return true;
}

Source opened(Nanoseconds restate, std::size_t memory_bytes) {
  SourceSettings settings;
  settings.source = "cell";
  settings.run = "7f3a";
  settings.restate = restate;
  settings.memory_bytes = memory_bytes;
  return Source::open(settings, sendNowhere).value();
}

enum class Formatter { standard, own };

/// The least that makes the same datagrams: a loop that formats the same values into them, keeps
/// nothing in mind and checks nothing.
class FormattingLoop {
 public:
  explicit FormattingLoop(Formatter formatter) : formatter_(formatter) {}

  void put(const std::string& name, const Joints& joints, std::size_t cycle) {
    if (at_ == nullptr) begin(cycle);
    char* const line = at_;
    at_ += std::string_view("joints ").copy(at_, 7);
    at_ += name.copy(at_, name.size());
    for (const double value : joints) {
      *at_++ = ' ';
      putNumber(value);
    }
    *at_++ = '\n';
    if (at_ - buffer_.data() <= 1200) return;
    const std::string_view late(line, static_cast<std::size_t>(at_ - line));
    at_ = line;
    send();
    begin(cycle);
    std::memmove(at_, late.data(), late.size());
    at_ += late.size();
  }

  void send() {
    if (at_ == nullptr) return;
    const auto size = static_cast<std::size_t>(at_ - buffer_.data());
    (void)send_(std::as_writable_bytes(std::span(buffer_.data(), size)));
    at_ = nullptr;
  }

 private:
  void begin(std::size_t cycle) {
    char* const end = buffer_.data() + buffer_.size();
    at_ = buffer_.data();
    at_ += std::string_view("RK1 cell@7f3a ").copy(at_, 14);
    at_ = std::to_chars(at_, end, sequence_++).ptr;
    *at_++ = ' ';
    putNumber(static_cast<double>(cycle) / 1000);
    *at_++ = '\n';
  }

  void putNumber(double value) {
    if (formatter_ == Formatter::own) {
      at_ += rk_number_text(at_, value);
      return;
    }
    at_ = std::to_chars(at_, at_ + 40, value, std::chars_format::fixed, 9).ptr;
    while (at_[-1] == '0') --at_;
    if (at_[-1] == '.') --at_;
  }

  Formatter formatter_;
  Source::Send send_ = sendNowhere;
  std::array<char, 4096> buffer_{};
  char* at_ = nullptr;  // null: no datagram is begun
  std::size_t sequence_ = 0;
};

void benchArm() {
  constexpr std::size_t kCycles = 200'000;
  std::vector<Joints> cycles;
  for (std::size_t cycle = 0; cycle < 4096; ++cycle) cycles.push_back(jointsAt(cycle, 0));
  Source source = opened(std::chrono::seconds(2), 1U << 20U);
  const SourceDevice arm = source.device("arm");
  std::size_t done = 0;
  const double each =
      bestOf([&] {
        for (std::size_t cycle = 0; cycle < kCycles; ++cycle, ++done) {
          const WallTime now(std::chrono::seconds(1'700'000'000) + std::chrono::milliseconds(done));
          (void)source.setJoints(arm, cycles[cycle % cycles.size()]);
          (void)source.flush(now);
        }
      })[0] /
      kCycles;
  std::printf("six-joint arm: %.0f ns a cycle (bar 1000)\n", each);
}

void benchDevices(double share) {
  constexpr std::size_t kDevices = 10'000;
  const auto moving = static_cast<std::size_t>(share * kDevices);
  const std::size_t cycles = 100'000 / moving;
  Source source = opened(std::chrono::seconds(0), std::size_t{64} << 20U);
  std::vector<std::string> names;
  std::vector<SourceDevice> devices;
  std::vector<std::vector<Joints>> values(2);
  for (std::size_t i = 0; i < kDevices; ++i) {
    names.push_back("device" + std::to_string(i));
    devices.push_back(source.device(names.back()));
    for (std::size_t set = 0; set < 2; ++set) values[set].push_back(jointsAt(set * 1000, i));
    (void)source.setJoints(devices.back(), values[1].back());
  }
  (void)source.flush(WallTime());
  // Each device moves with every turn: the two sets of values alternate.
  const auto eachMove = [&](std::size_t& cycle, const auto& move, const auto& flush) {
    for (std::size_t i = 0; i < cycles; ++i, ++cycle) {
      const std::size_t first = cycle * moving;
      for (std::size_t k = 0; k < moving; ++k) {
        const std::size_t device = (first + k) % kDevices;
        move(device, values[((first + k) / kDevices) % 2][device], cycle);
      }
      flush(cycle);
    }
  };
  std::array<std::size_t, 3> done{};
  FormattingLoop standard(Formatter::standard);
  FormattingLoop own(Formatter::own);
  const auto loopOver = [&](FormattingLoop& loop, std::size_t& cycle) {
    eachMove(
        cycle,
        [&](std::size_t device, const Joints& joints, std::size_t at) {
          loop.put(names[device], joints, at);
        },
        [&](std::size_t) { loop.send(); });
  };
  const std::array<double, 3> times = bestOf(
      [&] {
        eachMove(
            done[0],
            [&](std::size_t device, const Joints& joints, std::size_t) {
              (void)source.setJoints(devices[device], joints);
            },
            [&](std::size_t cycle) {
              (void)source.flush(WallTime(std::chrono::milliseconds(cycle)));
            });
      },
      [&] { loopOver(standard, done[1]); }, [&] { loopOver(own, done[2]); });
  const double lines = static_cast<double>(cycles * moving);
  std::printf(
      "%5.1f %% of 10,000 devices: %.0f ns a device; %.2f of std::to_chars (%.0f ns), "
      "%.2f of its own formatting (%.0f ns) (bar 1.3)\n",
      100 * share, times[0] / lines, times[0] / times[1], times[1] / lines, times[0] / times[2],
      times[2] / lines);
}

struct LoopCost {
  double mean_us = 0;
  double p99_us = 0;
};

/// A controller's cycle is computed, and sent if there is a source. Processor time of each.
LoopCost controllerLoop(Source* source, int seconds) {
  std::vector<double> costs;
  const SourceDevice arm = source == nullptr ? SourceDevice{} : source->device("arm");
  timespec next{};
  ::clock_gettime(CLOCK_MONOTONIC, &next);
  for (std::size_t cycle = 0; cycle < static_cast<std::size_t>(seconds) * 1000; ++cycle) {
    next.tv_nsec += 1'000'000;
    if (next.tv_nsec >= 1'000'000'000) ++next.tv_sec, next.tv_nsec -= 1'000'000'000;
    ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, nullptr);
    const double begin = threadNanoseconds();
    // Some 50 us of control: a sum that the compiler cannot leave out.
    Joints joints{};
    for (std::size_t i = 0; i < 400; ++i) {
      const Joints other = jointsAt(cycle, i);
      for (std::size_t joint = 0; joint < kJoints; ++joint) joints[joint] += 0.001 * other[joint];
    }
    if (source != nullptr) {
      (void)source->setJoints(arm, joints);
      (void)source->flush(
          std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now()));
    }
    costs.push_back((threadNanoseconds() - begin) / 1000);
    if (joints[0] == 12345) std::printf("\n");
  }
  LoopCost cost;
  for (const double each : costs) cost.mean_us += each / static_cast<double>(costs.size());
  const auto p99 = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() * 99 / 100);
  std::nth_element(costs.begin(), p99, costs.end());
  cost.p99_us = *p99;
  return cost;
}

void benchController(int seconds) {
  auto receiver = UdpReceiver::open(Endpoint::parse("udp://127.0.0.1:0").value());
  auto sender = receiver ? UdpSender::open(Endpoint::parse(boundText(*receiver)).value())
                         : Result<UdpSender>(receiver.error());
  if (!sender) {
    std::printf("controller: skipped: %s\n", sender.error().text().c_str());
    return;
  }
  SourceSettings settings;
  settings.source = "arm";
  Source source = Source::open(settings, [&](std::span<std::byte> datagram) {
                    return sender->send(datagram).ok();
                  }).value();
  const LoopCost alone = controllerLoop(nullptr, seconds);
  const LoopCost sending = controllerLoop(&source, seconds);
  std::printf(
      "controller, %d s at 1 kHz: %.1f us a cycle (p99 %.1f) without sending, %.1f (p99 "
      "%.1f) with: sending takes %.2f %% of the period\n",
      seconds, alone.mean_us, alone.p99_us, sending.mean_us, sending.p99_us,
      (sending.mean_us - alone.mean_us) / 10);
}

}  // namespace

int main(int count, char** arguments) {
  int seconds = 3;
  if (count == 3 && std::string_view(arguments[1]) == "--seconds")
    seconds = std::atoi(arguments[2]);
  if (seconds < 1 || count == 2) {
    std::fprintf(stderr, "usage: source_bench [--seconds N]\n");
    return 2;
  }
  benchArm();
  for (const double share : {0.001, 0.1, 1.0}) benchDevices(share);
  benchController(seconds);
  std::printf("(%zu bytes)\n", g_bytes);
}
