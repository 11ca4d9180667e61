#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/mcap/byte_cursor.h"

namespace rocinante::ros::test {

using Fields = std::vector<std::pair<std::string, Bytes>>;

template <class T>
Bytes littleEndian(T value) {
  Bytes out;
  mcap::appendNumber(out, value);
  return out;
}

inline Bytes bytesIn(std::string_view text) {
  const ByteView view = bytesOf(text);
  return {view.begin(), view.end()};
}

inline Bytes fieldBytes(const Fields& fields) {
  Bytes out;
  for (const auto& [name, value] : fields) {
    mcap::appendNumber(out, static_cast<std::uint32_t>(name.size() + 1 + value.size()));
    mcap::appendBytes(out, bytesOf(name + "="));
    mcap::appendBytes(out, value);
  }
  return out;
}

/// A record of a ROS 1 bag.
inline Bytes bagRecord(std::uint8_t op, Fields fields, const Bytes& data) {
  fields.insert(fields.begin(), {"op", littleEndian(op)});
  const Bytes header = fieldBytes(fields);
  Bytes out;
  mcap::appendNumber(out, static_cast<std::uint32_t>(header.size()));
  mcap::appendBytes(out, header);
  mcap::appendNumber(out, static_cast<std::uint32_t>(data.size()));
  mcap::appendBytes(out, data);
  return out;
}

inline Bytes bagConnection(std::uint32_t number, const std::string& topic,
                           const std::string& type) {
  return bagRecord(7, {{"conn", littleEndian(number)}, {"topic", bytesIn(topic)}},
                   fieldBytes({{"topic", bytesIn(topic)},
                               {"type", bytesIn(type)},
                               {"md5sum", bytesIn("*")},
                               {"message_definition", bytesIn("float64 x")}}));
}

inline Bytes bagMessage(std::uint32_t connection, std::uint32_t seconds, const Bytes& payload) {
  return bagRecord(
      2, {{"conn", littleEndian(connection)}, {"time", littleEndian(std::uint64_t{seconds})}},
      payload);
}

/// A whole bag: one chunk with these records, and an index of the connections.
inline Bytes bagOf(const Bytes& records, const Bytes& connections, const std::string& compression,
                   const Bytes& stored) {
  const Bytes chunk =
      bagRecord(5,
                {{"compression", bytesIn(compression)},
                 {"size", littleEndian(static_cast<std::uint32_t>(records.size()))}},
                stored);
  const auto head = [&](std::uint64_t index) {
    return bagRecord(3,
                     {{"index_pos", littleEndian(index)},
                      {"conn_count", littleEndian(std::uint32_t{1})},
                      {"chunk_count", littleEndian(std::uint32_t{1})}},
                     {});
  };
  Bytes out = bytesIn("#ROSBAG V2.0\n");
  mcap::appendBytes(out, head(out.size() + head(0).size() + chunk.size()));
  mcap::appendBytes(out, chunk);
  mcap::appendBytes(out, connections);
  return out;
}

}  // namespace rocinante::ros::test
