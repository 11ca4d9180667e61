#include "core/signing/signed_datagram.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/base64.h"
#include "core/packet/text_lines.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

/// Signed in front of the datagram, so that the signature means nothing elsewhere.
constexpr std::string_view kDomain = "rocinante-rk1\n";
constexpr std::string_view kWord = "sig ";
constexpr std::string_view kAt = "at=";
constexpr std::size_t kKeyIdDigits = 16;
constexpr std::size_t kBase64Bytes = 88;
/// `sig KEYID BASE64` with its LF: one spelling only, so that no byte of it can be changed.
constexpr std::size_t kLineBytes = kWord.size() + kKeyIdDigits + 1 + kBase64Bytes + 1;
static_assert(kSignatureBytes == kLineBytes + 1 + 1 + kAt.size() + 19);

std::optional<KeyId> readKeyId(std::string_view digits) {
  const auto is_upper = [](char each) { return each >= 'A' && each <= 'F'; };
  if (std::any_of(digits.begin(), digits.end(), is_upper)) return std::nullopt;
  return readHex(digits, kKeyIdDigits);
}

bool isSignatureLine(std::string_view line) { return TextFields(line).take() == "sig"; }

/// The last line of `text`, its LF included.
std::string_view lastLine(std::string_view text) {
  const std::size_t feed = text.substr(0, text.empty() ? 0 : text.size() - 1).rfind('\n');
  return text.substr(feed == text.npos ? 0 : feed + 1);
}

/// The first line that packet text does not ignore, without separators at its end; empty unless it
/// begins with RK1 or RKS1.
std::string_view headerOf(std::string_view text, bool& is_packet) {
  TextLines lines(text);
  std::string_view line;
  if (!lines.next(line)) return {};
  const std::string_view word = TextFields(line).take();
  is_packet = word == "RK1";
  if (!is_packet && word != "RKS1") return {};
  return line.substr(0, line.find_last_not_of(" \t") + 1);
}

/// The last word of the header, with its leading separator, when it is `at=`; otherwise empty.
std::string_view atWord(std::string_view header) {
  const std::size_t before = header.find_last_of(" \t");
  if (before == header.npos || !header.substr(before + 1).starts_with(kAt)) return {};
  return header.substr(before);
}

ParsedSignature refused(Untrusted reason) { return {reason, {}}; }

}  // namespace

ParsedSignature parseSignature(ByteView datagram) {
  const std::string_view all = textOf(datagram);
  const std::string_view line = lastLine(all);
  if (!isSignatureLine(line)) return refused(Untrusted::not_signed);
  ParsedSignature parsed;
  SignedDatagram& signed_one = parsed.datagram;
  signed_one.text = all.substr(0, all.size() - line.size());
  signed_one.header = headerOf(signed_one.text, signed_one.is_packet);
  if (signed_one.header.empty()) return refused(Untrusted::not_signed);
  if (line.size() != kLineBytes || !line.starts_with(kWord) || line.back() != '\n' ||
      line[kWord.size() + kKeyIdDigits] != ' ') {
    return refused(Untrusted::malformed);
  }
  const auto key = readKeyId(line.substr(kWord.size(), kKeyIdDigits));
  const std::string_view base64 = line.substr(kLineBytes - 1 - kBase64Bytes, kBase64Bytes);
  const auto signature = readBase64<64>(base64);
  if (!key || !signature) return refused(Untrusted::malformed);
  signed_one.key = *key;
  signed_one.signature = *signature;
  const std::string_view word = atWord(signed_one.header);
  if (word.empty()) return refused(Untrusted::malformed);
  const auto at_ns = readUnsigned(word.substr(1 + kAt.size()));
  if (!at_ns || *at_ns > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    return refused(Untrusted::malformed);
  }
  signed_one.at_ns = static_cast<std::int64_t>(*at_ns);
  return parsed;
}

bool isSignedBy(const PublicKey& key, const SignedDatagram& datagram, std::string& scratch) {
  scratch.assign(kDomain);
  scratch += datagram.text;
  return isSignatureOf(key, bytesOf(scratch), datagram.signature);
}

DatagramSigner::DatagramSigner(SigningKey key, std::function<WallTime()> now)
    : key_(std::move(key)), now_(std::move(now)) {}

ByteView DatagramSigner::sign(ByteView datagram) {
  std::string_view text = textOf(datagram);
  while (text.ends_with('\0')) text.remove_suffix(1);
  if (const std::string_view line = lastLine(text); isSignatureLine(line)) {
    text.remove_suffix(line.size());
  }
  bool is_packet = false;
  const std::string_view header = headerOf(text, is_packet);
  if (header.empty()) return {};
  const std::string_view rest =
      text.substr(static_cast<std::size_t>(header.data() - text.data()) + header.size());
  text.remove_suffix(rest.size() + atWord(header).size());

  last_at_ns_ = std::max<std::int64_t>(now_().time_since_epoch().count(), last_at_ns_ + 1);
  buffer_.assign(kDomain);
  buffer_ += text;
  buffer_ += ' ';
  buffer_ += kAt;
  appendUnsigned(buffer_, static_cast<std::uint64_t>(last_at_ns_));
  buffer_ += rest;
  if (buffer_.back() != '\n') buffer_ += '\n';
  const Signature signature = key_.sign(bytesOf(buffer_));
  buffer_ += kWord;
  appendHex(buffer_, key_.id(), kKeyIdDigits);
  buffer_ += ' ';
  buffer_ += base64Of(signature);
  buffer_ += '\n';
  return bytesOf(std::string_view(buffer_).substr(kDomain.size()));
}

}  // namespace rocinante
