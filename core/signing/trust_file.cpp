#include "core/signing/trust_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/document/toml_table.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxTrustFileBytes = 1U << 20U;
/// Bounds the memory of those that verify: 64 KiB a key.
constexpr std::size_t kMaxKeys = 1024;
constexpr std::string_view kRule = "trust";

TrustedKey readKey(TomlTable& table) {
  TrustedKey trusted;
  const auto text = table.requiredText("public");
  const auto key = text ? readPublicKeyText(*text) : std::nullopt;
  if (text && !key) {
    table.error(kRule, "public", "a public key must be 44 characters of base64");
  }
  trusted.key = key.value_or(PublicKey{});
  trusted.id = keyIdOf(trusted.key);
  trusted.sources = table.texts("sources");
  trusted.is_relay = table.flag("relay").value_or(false);
  if (std::ranges::any_of(trusted.sources, &std::string::empty)) {
    table.error(kRule, "sources", "a pattern must not be empty");
  }
  if (trusted.sources.empty() && !trusted.is_relay) {
    table.error(kRule, "sources", "this key may say nothing: it needs `sources` or `relay = true`");
  }
  table.finish();
  return trusted;
}

void readKeys(const TomlNode& document, FaultList& faults, std::vector<TrustedKey>& keys) {
  TomlTable root(document, "a trust file", faults);
  std::vector<TomlTable> tables = root.tables("key", "[[key]]");
  root.finish();
  if (tables.empty()) faults.error(kRule, root.place(), "the file lists no [[key]]");
  if (tables.size() > kMaxKeys) {
    faults.error(kRule, root.place("key"), fmt::format("more than {} keys", kMaxKeys));
    return;
  }
  for (TomlTable& table : tables) {
    TrustedKey trusted = readKey(table);
    const auto place = std::ranges::lower_bound(keys, trusted.id, {}, &TrustedKey::id);
    if (place != keys.end() && place->id == trusted.id) {
      table.error(kRule, "public", fmt::format("key {} is listed twice", keyIdText(trusted.id)));
      continue;
    }
    keys.insert(place, std::move(trusted));
  }
}

std::string tomlString(std::string_view text) {
  std::string quoted = "\"";
  for (const char each : text) {
    const auto byte = static_cast<unsigned char>(each);
    if (byte < 0x20 || byte == 0x7F) {
      quoted += fmt::format("\\u{:04x}", byte);
    } else {
      if (each == '"' || each == '\\') quoted += '\\';
      quoted += each;
    }
  }
  return quoted + '"';
}

}  // namespace

Result<TrustFile> TrustFile::read(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, kMaxTrustFileBytes);
  if (!text) return text.error();
  return parse(*text, path.string());
}

Result<TrustFile> TrustFile::parse(std::string_view text, const std::string& name) {
  const Result<TomlNode> document = parseToml(text, name);
  if (!document) return document.error();
  TrustFile file;
  Findings found;
  {
    FaultList faults(found, name);
    readKeys(*document, faults, file.keys);
  }
  if (found.empty()) return file;
  const Finding& first = found.front();
  const std::string hint = first.hint.empty() ? "" : " (" + first.hint + ")";
  return Error{ErrorKind::bad_argument, first.text + hint,
               fmt::format("{}:{}:{}", name, first.line, first.column)};
}

const TrustedKey* TrustFile::find(KeyId id) const {
  const auto place = std::ranges::lower_bound(keys, id, {}, &TrustedKey::id);
  return place != keys.end() && place->id == id ? &*place : nullptr;
}

std::string trustText(const TrustedKey& key) {
  std::string text =
      fmt::format("# {}\n[[key]]\npublic = \"{}\"\n", keyIdText(key.id), publicKeyText(key.key));
  if (!key.sources.empty()) {
    text += "sources = [";
    for (const std::string& each : key.sources) {
      text += (text.ends_with('[') ? "" : ", ") + tomlString(each);
    }
    text += "]\n";
  }
  if (key.is_relay) text += "relay = true\n";
  return text;
}

}  // namespace rocinante
