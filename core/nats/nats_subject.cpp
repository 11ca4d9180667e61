#include "core/nats/nats_subject.h"

namespace rocinante {
namespace {

constexpr std::string_view kNoSource = "_octets";

}  // namespace

std::string subjectWord(std::string_view source) {
  std::string word;
  for (const char c : encodeName(source)) {
    if (c == '.') {
      word += "%2E";
    } else {
      word += c;
    }
  }
  return word;
}

const std::string& SubjectOf::operator()(ByteView payload) {
  const PacketHeader* const header = decoder_.decodeHeader(payload);
  const std::string_view source = header != nullptr ? header->source : std::string_view();
  if (subject_.empty() || source != source_) {
    source_ = source;
    subject_ = base_ + "." + (source.empty() ? std::string(kNoSource) : subjectWord(source));
  }
  return subject_;
}

}  // namespace rocinante
