// Moves an arm of two joints and says everything again every 2 s.
// g++ -std=c++20 sender.cpp $(pkg-config --cflags --libs rocinante-source rocinante-net) -o sender
// ./sender udp://127.0.0.1:19960 [CYCLES]
#include <rocinante/source.h>
#include <rocinante/udp_socket.h>

#include <array>
#include <cstdio>
#include <string>
#include <thread>

using namespace rocinante;

int main(int count, char** arguments) {
  const auto to = Endpoint::parse(count > 1 ? arguments[1] : "udp://127.0.0.1:19960");
  if (!to) return std::fprintf(stderr, "%s\n", to.error().text().c_str()), 2;
  auto sender = UdpSender::open(*to);
  if (!sender) return std::fprintf(stderr, "%s\n", sender.error().text().c_str()), 2;

  const auto now = [] { return std::chrono::system_clock::now(); };
  const std::string run = std::to_string(now().time_since_epoch().count());
  SourceSettings settings;
  settings.source = "sim";
  settings.run = run;
  auto source = Source::open(
      settings, [&](std::span<std::byte> datagram) { return sender->send(datagram).ok(); });
  if (!source) return std::fprintf(stderr, "%s\n", source.error().text().c_str()), 2;

  const SourceDevice arm = source->device("arm");
  const std::array<std::string_view, 2> names = {"shoulder", "elbow"};
  SourceResult result = source->setOrder(arm, names);
  const int cycles = count > 2 ? std::stoi(arguments[2]) : -1;
  for (int i = 0; i != cycles && result == SourceResult::done; ++i) {
    result = source->setJoints(arm, std::array{0.004 * (i % 200), 0.006 * (i % 200)});
    if (source->flush(now()) == SourceResult::not_sent) std::puts("a datagram was not sent");
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return result == SourceResult::done ? 0 : (std::puts(sentenceOf(result).data()), 1);
}
