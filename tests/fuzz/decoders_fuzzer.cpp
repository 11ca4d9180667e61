// Decoders: any declaration is read or refused with a sentence; what decoders of every kind make of
// any datagram is a packet without faults.
#include <cstdlib>
#include <string_view>

#include "core/foreign/decode/datagram_decoders.h"
#include "core/packet/packet_text.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

constexpr std::string_view kDeclarations[] = {
    R"([[decoder]]
name = "a"
kind = "struct"
checksum = { kind = "crc16-mcrf4xx", from = 1, until = -2, at = -2, then = "27" }
zero_filled = true
[[decoder.field]]
name = "n"
at = 1
type = "i24"
bits = [3, 11]
[[decoder.field]]
name = "q"
at = 4
type = "f64"
count = 3
[[decoder.field]]
name = "t"
at = 0
type = "text"
bytes = 6
[[decoder.joints]]
device = "arm-{t}"
joints = ["a", "b"]
fields = ["q[0]", "n"]
[[decoder.pose]]
device = "p"
position = ["q[0]", "q[1]", "q[2]"]
euler = ["n", "-q[1]", 1]
euler_order = "zyx"
[[decoder.signal]]
path = "{t}"
name = "{t}"
field = "n"
bits = [2, 9]
values = { "1" = "one" }
[[decoder.signal]]
path = "-"
name = "t"
field = "t"
text = true
[[decoder.signals]]
path = "arm/{t}"
names = ["a", "b"]
fields = ["q[0]", "n"]
scale = 1e300
unit = "A"
[[decoder.event]]
text = "{t}"
changes = "n"
)",
    R"([[decoder]]
name = "a"
kind = "struct"
[[decoder.field]]
name = "q"
at = 1
type = "f32"
count = 4
byte_order = "big"
[[decoder.pose]]
device = "p"
quaternion = ["q[0]", "q[1]", "q[2]", "q[3]"]
quaternion_order = "wxyz"
)",
    R"([[decoder]]
name = "a"
kind = "delimited"
separator = ";"
[[decoder.field]]
name = "t"
column = 0
[[decoder.field]]
name = "q"
column = 1
[[decoder.joint]]
device = "{t}"
joint = "j"
field = "q"
times = 1e300
[[decoder.event]]
text = "{t} {q}"
changes = "t"
)",
    R"([[decoder]]
name = "a"
kind = "delimited"
checksum = { kind = "xor8" }
[[decoder.field]]
name = "q"
column = 1
[[decoder.joint]]
device = "d"
joint = "j"
field = "q"
)",
    R"([[decoder]]
name = "a"
kind = "json"
[[decoder.field]]
name = "t"
at = "/a/0"
[[decoder.field]]
name = "q"
at = "/b"
[[decoder.joint]]
device = "{t}"
joint = "j"
field = "q"
)",
    R"([[decoder]]
name = "a"
kind = "xml"
[[decoder.field]]
name = "t"
at = "A@B"
[[decoder.field]]
name = "q"
at = "C/D"
[[decoder.joint]]
device = "{t}"
joint = "j"
field = "q"
)",
    R"([[decoder]]
name = "a"
kind = "dis"
origin = { latitude = 42, longitude = -71, height = 10 }
[[decoder.field]]
name = "m"
at = "marking"
[[decoder.field]]
name = "x"
at = "local.x"
[[decoder.field]]
name = "w"
at = "local.qw"
[[decoder.field]]
name = "t"
at = "primary-turret-1.azimuth"
[[decoder.joints]]
device = "{m}"
joints = ["a", "b", "c"]
fields = ["x", "w", "t"]
)",
};
constexpr std::size_t kDeclarationCount = sizeof kDeclarations / sizeof kDeclarations[0];

void readDatagrams(std::size_t which, ByteView bytes) {
  auto set = decode::parseDecoders(kDeclarations[which], "fuzz");
  require(set.has_value());
  decode::DatagramDecoders decoders(*set);
  PacketTextDecoder reader;
  // Two datagrams, so that events are said.
  for (const ByteView each : {bytes.first(bytes.size() / 2), bytes}) {
    const decode::Route route{1, "10.0.0.1:2", "/udp/1/10.0.0.1"};
    (void)decoders.undeclared(route, each, 20);
    const decode::DecodedPacket* const packet = decoders.decode(route, 1, each);
    if (packet == nullptr) continue;
    require(reader.decode(bytesOf(packet->text)) != nullptr);
    require(reader.faults().empty());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const ByteView bytes(reinterpret_cast<const std::byte*>(data) + 1, size - 1);
  const std::size_t which = data[0] % (kDeclarationCount + 1);
  if (which < kDeclarationCount) {
    readDatagrams(which, bytes);
    return 0;
  }
  const auto set = decode::parseDecoders(textOf(bytes), "fuzz");
  if (!set) {
    require(!set.error().what.empty());
  } else {
    require(!(*set)->decoders.empty() && (*set)->hash.size() == 64);
  }
  return 0;
}
