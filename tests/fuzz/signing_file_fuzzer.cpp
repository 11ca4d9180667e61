// Key and trust files: what is read is bounded and consistent, and a trust file that is written
// again reads back the same.
#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "core/signing/trust_file.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

void readTrust(std::string_view text) {
  const auto trust = TrustFile::parse(text, "fuzz");
  if (!trust) return;
  require(!trust->keys.empty() && trust->keys.size() <= 1024);
  std::string written;
  for (const TrustedKey& key : trust->keys) {
    require(key.id == keyIdOf(key.key) && trust->find(key.id) == &key);
    require(key.is_relay || !key.sources.empty());
    written += trustText(key);
  }
  const auto again = TrustFile::parse(written, "fuzz");
  require(again && again->keys.size() == trust->keys.size());
  for (std::size_t i = 0; i < again->keys.size(); ++i) {
    require(again->keys[i].sources == trust->keys[i].sources);
    require(again->keys[i].is_relay == trust->keys[i].is_relay);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto key = SigningKey::parse(text, "fuzz")) {
    require(parsePublicKey(text, "fuzz").value() == key->publicKey());
    require(isSignatureOf(key->publicKey(), bytesOf(text), key->sign(bytesOf(text))));
  }
  readTrust(text);
  return 0;
}
