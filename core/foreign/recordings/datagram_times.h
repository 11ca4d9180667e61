#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// A file of a folder of datagrams.
struct DatagramFile {
  std::string name;
  std::int64_t changed_ns = 0;  ///< since 1970
  std::uint64_t bytes = 0;
};

struct TimedDatagram {
  std::string name;
  LogTime time{};
};

/// The datagrams in order, with their times.
struct DatagramOrder {
  enum class Rule : std::uint8_t { names_are_times, names_are_numbers, changed };
  Rule rule = Rule::changed;
  std::vector<TimedDatagram> datagrams;
  /// Of names_are_numbers: files that were changed before the one in front of them, and have its
  /// time.
  std::size_t held = 0;
};

/// By docs/other-formats.md, "Folders of datagrams".
DatagramOrder orderedDatagrams(std::vector<DatagramFile> files);

}  // namespace rocinante
