// Calls of the C header of sources in an order that the input chooses, with any name, number and
// time: every datagram is a packet without faults that keeps within its size, and whoever hears all
// of them never sees a gap.
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"

#define RK_SOURCE_STATIC
#define RK_SOURCE_IMPLEMENTATION
#include "core/source/rocinante/rocinante_source.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

/// Takes values from the input; zeros behind its end.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool empty() const { return size_ == 0; }
  std::uint8_t byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  std::uint64_t word() {
    std::uint64_t word = 0;
    for (int i = 0; i < 8; ++i) word = (word << 8U) | byte();
    return word;
  }
  /// Mostly small, sometimes any double.
  double number() {
    const std::uint8_t kind = byte();
    if (kind != 0) return (kind - 128) / 16.0;
    const std::uint64_t bits = word();
    double number = 0;
    std::memcpy(&number, &bits, sizeof number);
    return number;
  }
  std::vector<double> numbers(std::size_t count) {
    std::vector<double> numbers(count);
    for (double& each : numbers) each = number();
    return numbers;
  }
  /// One of a few names, or any bytes.
  const char* text() {
    static const char* const kNames[] = {"a", "arm", "layer", "x/y", "\xC3\xA9", "b c", ""};
    const std::uint8_t kind = byte();
    if (kind == 0) return nullptr;
    if (kind < 200) return kNames[kind % std::size(kNames)];
    std::string& kept = texts_.emplace_back();
    for (std::size_t left = kind < 250 ? byte() % 16 : byte() * 20; left > 0; --left) {
      kept += static_cast<char>(byte());
    }
    return kept.c_str();
  }
  rk_path path() {
    switch (byte() % 4) {
      case 0:
        return rk_world();
      case 1:
        return rk_whole(text());
      case 2:
        return rk_link(text(), text());
      default:
        return rk_path_of(text(), text(), text());
    }
  }
  void forgetTexts() { texts_.clear(); }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::vector<std::string> texts_ = [] {
    std::vector<std::string> texts;
    texts.reserve(64);  // never moved while borrowed
    return texts;
  }();
};

struct Receiver {
  std::size_t most_bytes = 0;
  PacketTextDecoder decoder;
  SessionState state;
  std::uint64_t heard = 0;
};

int hear(void* context, char* bytes, std::size_t size) {
  auto& receiver = *static_cast<Receiver*>(context);
  require(size > 0 && size <= receiver.most_bytes);
  std::memset(bytes + size, '#', 7);  // the reserved bytes
  const std::string datagram(bytes, size);
  const Packet* const packet = receiver.decoder.decode(bytesOf(datagram));
  require(packet != nullptr && packet->faults.empty());
  require(packet->header.sequence == receiver.heard++);
  require(receiver.state.apply({}, *packet) == Applied::yes);
  return static_cast<int>(receiver.heard % 5 == 0);
}

void call(rk_source* s, Input& in, rk_device device) {
  const char* const names[] = {in.text(), in.text(), in.text()};
  const std::size_t count = in.byte() % 8;
  const std::vector<double> numbers = in.numbers(33);
  const rk_path path = in.path();
  const std::uint64_t hash = in.word();
  const std::uint32_t rgba = static_cast<std::uint32_t>(hash);
  int result = 0;
  switch (in.byte() % 19) {
    case 0:
      result = rk_source_add(s, device, names[0], count > 4 ? &hash : nullptr);
      break;
    case 1:
      result = rk_source_remove(s, device);
      break;
    case 2:
      result = rk_source_forget(s, device);
      break;
    case 3:
      result = rk_source_order(s, device, names, count % 4);
      break;
    case 4:
    case 5:
      result = rk_source_joints(s, device, numbers.data(), count);
      break;
    case 6: {
      const double pose[] = {
          numbers[0], numbers[1], numbers[2], 0, 0, 0, count > 1 ? 1 : numbers[3]};
      result = rk_source_pose(s, device, pose, path);
      break;
    }
    case 7:
      result = rk_source_show(s, path, static_cast<rk_shown>(count % 3));
      break;
    case 8:
      result = rk_source_color(s, path, rgba);
      break;
    case 9:
      result = rk_source_color_default(s, path);
      break;
    case 10:
      result = rk_source_line(s, names[0], rgba, numbers[32], path, numbers.data(), count);
      break;
    case 11: {
      const std::vector<double> many(std::size_t{3} * (1 + in.byte()), numbers[0]);
      result = rk_source_points(s, names[0], rgba, 1, path, many.data(), many.size() / 3);
      break;
    }
    case 12:
      result = rk_source_label(s, names[0], path, numbers.data(), names[1]);
      break;
    case 13:
      result = rk_source_erase(s, names[0]);
      break;
    case 14: {
      rk_view view{};
      std::memcpy(&view, numbers.data(), sizeof view);
      result = rk_source_view(s, names[0], &view, path);
      break;
    }
    case 15:
      result = rk_source_event(s, names[0]);
      break;
    case 16:
      result = rk_source_device(s, names[0]);
      break;
    case 17:
      result = rk_source_repeat(s, device);
      break;
    default: {
      const auto now = static_cast<std::int64_t>(count == 0 ? hash : hash % 4'000'000'000);
      result = rk_source_flush_at(s, now, count == 1 ? -1 : now);
      break;
    }
  }
  require(rk_result_text(result) != nullptr);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Receiver receiver;
  std::vector<char> memory(8'000 + std::size_t{in.byte()} * 256);
  rk_source_config config{};
  config.source = "s";
  config.run = in.byte() % 2 == 0 ? "r" : nullptr;
  config.restate_ns = static_cast<std::int64_t>(in.word() % 3'000'000'000);
  config.max_datagram = in.byte() % 2 == 0 ? 0 : 140 + in.byte();
  config.reserved_bytes = 7;
  config.send = hear;
  config.context = &receiver;
  receiver.most_bytes = config.max_datagram == 0 ? 1200 : config.max_datagram;
  rk_source* const source = rk_source_open(memory.data(), memory.size(), &config, nullptr);
  if (source == nullptr) return 0;
  while (!in.empty()) {
    const std::uint8_t which = in.byte();
    rk_device device = rk_source_device(source, which % 2 == 0 ? "a" : "arm");
    if (which > 200) device = static_cast<rk_device>(in.word());
    call(source, in, device);
    in.forgetTexts();
  }
  rk_source_flush(source, 0);
  require(rk_source_sent(source) == receiver.heard);
  return 0;
}
