#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/signing/signing_key.h"

namespace rocinante {

/// A key and what it may say.
struct TrustedKey {
  KeyId id = 0;
  PublicKey key{};
  std::vector<std::string> sources;  ///< patterns of SOURCEs (core/base/pattern.h)
  bool is_relay = false;             ///< may also say `by=`, `via=` and subscription lines
};

/// A trust file (docs/signing.md): whose datagrams are accepted.
struct TrustFile {
  std::vector<TrustedKey> keys;  ///< sorted by id, each once; at least one

  /// not_found or unreadable when the file is; bad_argument or damaged with FILE:LINE:COLUMN of its
  /// first fault.
  static Result<TrustFile> read(const std::filesystem::path& path);
  static Result<TrustFile> parse(std::string_view text, const std::string& name);

  /// Null when the file does not list it.
  const TrustedKey* find(KeyId id) const;
};

/// A `[[key]]` of a trust file, with a comment that names the key.
std::string trustText(const TrustedKey& key);

}  // namespace rocinante
