#pragma once

#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/packet/packet_text.h"

namespace rocinante {

/// A SOURCE as one word of a subject: as packets write it, with dots as %2E.
std::string subjectWord(std::string_view source);

/// The subject of each datagram of a sink: SUBJECT.SOURCE, and SUBJECT._octets for datagrams that
/// are not packet text. One thread.
class SubjectOf {
 public:
  explicit SubjectOf(std::string base) : base_(std::move(base)) {}

  /// Valid until the next call.
  const std::string& operator()(ByteView payload);

 private:
  std::string base_;
  PacketTextDecoder decoder_;
  std::string source_;   ///< of the datagram before
  std::string subject_;  ///< empty: none yet
};

}  // namespace rocinante
