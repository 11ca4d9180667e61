// Any bytes as ROS messages of every type that is translated: the first byte chooses the type and
// the serialization. What comes out is a packet without a fault, and one made beside its text is
// the same.

#include <cstdlib>
#include <cstring>

#include "core/foreign/ros/ros_translator.h"
#include "core/packet/packet_text.h"

namespace {

using namespace rocinante;

void requirePacket(const ros::Translated& made) {
  PacketTextDecoder decoder;
  const Packet* const decoded = decoder.decode(bytesOf(made.text));
  if (decoded == nullptr) std::abort();
  for (const FaultAt& fault : decoded->faults) {
    // A text may grow beyond the limit by characters that a string cannot hold.
    if (fault.fault != PacketFault::bad_string && fault.fault != PacketFault::too_many)
      std::abort();
  }
  if (made.packet == nullptr) return;
  if (decoded->statements.size() != made.packet->statements.size()) std::abort();
  for (std::size_t i = 0; i < decoded->statements.size(); ++i) {
    const Statement& a = decoded->statements[i];
    const Statement& b = made.packet->statements[i];
    if (a.name != b.name || a.numbers.size() != b.numbers.size() ||
        std::memcmp(a.numbers.data(), b.numbers.data(), a.numbers.size_bytes()) != 0) {
      std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const ros::DeviceFinder devices(nullptr, "");
  ros::RosTranslator translator(devices);
  static const std::vector<std::string_view> kTypes = ros::translatedTypes();
  const std::string_view type = kTypes[(data[0] >> 1U) % kTypes.size()];
  const auto layout =
      data[0] % 2 == 0 ? ros::FieldCursor::Layout::cdr : ros::FieldCursor::Layout::ros1;
  const std::size_t topic = *translator.addTopic("/fuzz/topic", type, layout);
  const ByteView message(reinterpret_cast<const std::byte*>(data) + 1, size - 1);
  for (const std::size_t length : {message.size(), message.size(), message.size() / 2}) {
    ros::Translated made;
    const auto outcome = translator.translate(topic, LogTime{}, message.first(length), made);
    if (outcome == ros::RosTranslator::Outcome::packet) requirePacket(made);
  }
  return 0;
}
