#include "core/signing/signing_key.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/base64.h"

namespace rocinante {
namespace {

using Seed = std::array<unsigned char, 32>;

constexpr std::string_view kPublicWord = "rocinante-public ";
constexpr std::string_view kSecretWord = "rocinante-secret ";
constexpr std::uint64_t kMaxKeyFileBytes = 4096;

/// libsodium chooses its implementations for this processor once; thread-safe, cheap when repeated.
void startSodium() {
  if (::sodium_init() < 0) std::abort();  // no random numbers: the system is broken
}

Error damaged(std::string what, const std::string& name, int line) {
  return {ErrorKind::damaged, std::move(what), fmt::format("{}, line {}", name, line)};
}

/// The next line without its LF.
std::string_view takeLine(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  return line;
}

/// The key behind `word` in the next line.
Result<Seed> takeKey(std::string_view& text, std::string_view word, const std::string& name,
                     int line) {
  const std::string_view first_line = takeLine(text);
  const auto key =
      first_line.starts_with(word) ? readBase64<32>(first_line.substr(word.size())) : std::nullopt;
  if (key) return *key;
  return damaged(fmt::format("the line must be `{}` and 44 characters of base64", word), name,
                 line);
}

struct Wiped {
  std::string& text;
  ~Wiped() { ::sodium_memzero(text.data(), text.size()); }
};

Error systemError(std::string_view what, const std::filesystem::path& path) {
  const int code = errno;
  return {code == ENOENT ? ErrorKind::not_found : ErrorKind::unreadable,
          fmt::format("{}: {}", what, std::strerror(code)), path.string()};
}

/// Creates a file that did not exist.
Status create(const std::filesystem::path& path, std::string_view text, mode_t mode) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (file < 0 && errno == EEXIST) {
    return Error{ErrorKind::refused, "the file exists, and a key is never replaced", path.string()};
  }
  if (file < 0) return systemError("cannot create", path);
  const bool whole = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
                     ::fsync(file) == 0;
  const Status written = whole ? Status() : Status(systemError("cannot write", path));
  if (::close(file) != 0 && written) return systemError("cannot write", path);
  if (!written) ::unlink(path.c_str());
  return written;
}

std::filesystem::path publicPath(const std::filesystem::path& path) {
  return path.string() + ".pub";
}

}  // namespace

KeyId keyIdOf(const PublicKey& key) {
  std::array<unsigned char, 32> digest{};
  ::crypto_generichash(digest.data(), digest.size(), key.data(), key.size(), nullptr, 0);
  KeyId id = 0;
  for (std::size_t i = 0; i < 8; ++i) id = id << 8U | digest[i];
  return id;
}

std::string keyIdText(KeyId id) { return fmt::format("{:016x}", id); }

std::string publicKeyText(const PublicKey& key) { return base64Of(key); }

std::optional<PublicKey> readPublicKeyText(std::string_view text) { return readBase64<32>(text); }

bool isSignatureOf(const PublicKey& key, ByteView bytes, const Signature& signature) {
  startSodium();
  return ::crypto_sign_ed25519_verify_detached(signature.data(),
                                               reinterpret_cast<const unsigned char*>(bytes.data()),
                                               bytes.size(), key.data()) == 0;
}

SigningKey SigningKey::make() {
  startSodium();
  Seed seed{};
  ::randombytes_buf(seed.data(), seed.size());
  SigningKey key = ofSeed(seed);
  ::sodium_memzero(seed.data(), seed.size());
  return key;
}

SigningKey SigningKey::ofSeed(const Seed& seed) {
  startSodium();
  SigningKey key;
  ::crypto_sign_ed25519_seed_keypair(key.public_.data(), key.secret_.data(), seed.data());
  key.id_ = keyIdOf(key.public_);
  return key;
}

SigningKey::~SigningKey() { ::sodium_memzero(secret_.data(), secret_.size()); }

SigningKey::SigningKey(SigningKey&& other) noexcept
    : public_(other.public_), id_(other.id_), secret_(other.secret_) {
  ::sodium_memzero(other.secret_.data(), other.secret_.size());
}

SigningKey& SigningKey::operator=(SigningKey&& other) noexcept {
  std::swap(public_, other.public_);
  std::swap(id_, other.id_);
  std::swap(secret_, other.secret_);
  return *this;
}

Result<SigningKey> SigningKey::read(const std::filesystem::path& path) {
  Result<std::string> text = readFile(path, kMaxKeyFileBytes);
  if (!text) return text.error();
  const Wiped wiped{*text};
  Result<SigningKey> key = parse(*text, path.string());
  if (!key) return key;
  struct stat facts {};
  if (::stat(path.c_str(), &facts) != 0) return systemError("cannot open", path);
  if ((facts.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    return Error{ErrorKind::refused,
                 "others than the owner have access to this secret key: chmod 600 it",
                 path.string()};
  }
  return key;
}

Result<SigningKey> SigningKey::parse(std::string_view text, const std::string& name) {
  const auto public_key = takeKey(text, kPublicWord, name, 1);
  if (!public_key) return public_key.error();
  if (text.empty()) {
    return damaged("the secret line is missing: this is a public key", name, 2);
  }
  auto seed = takeKey(text, kSecretWord, name, 2);
  if (!seed) return seed.error();
  SigningKey key = ofSeed(*seed);
  ::sodium_memzero(seed->data(), seed->size());
  if (key.public_ != *public_key) {
    return damaged("the public and the secret line do not belong together", name, 2);
  }
  if (!text.empty()) return damaged("a key file has two lines", name, 3);
  return key;
}

Status SigningKey::write(const std::filesystem::path& path) const {
  const std::string public_line = fmt::format("{}{}\n", kPublicWord, base64Of(public_));
  Seed seed{};
  std::copy_n(secret_.begin(), seed.size(), seed.begin());
  std::string text = fmt::format("{}{}{}\n", public_line, kSecretWord, base64Of(seed));
  const Wiped wiped{text};
  ::sodium_memzero(seed.data(), seed.size());
  if (Status made = create(publicPath(path), public_line, 0644); !made) return made;
  Status made = create(path, text, 0600);
  if (!made) ::unlink(publicPath(path).c_str());
  return made;
}

Signature SigningKey::sign(ByteView bytes) const {
  Signature signature{};
  ::crypto_sign_ed25519_detached(signature.data(), nullptr,
                                 reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                                 secret_.data());
  return signature;
}

Result<PublicKey> readPublicKey(const std::filesystem::path& path) {
  Result<std::string> text = readFile(path, kMaxKeyFileBytes);
  if (!text) return text.error();
  const Wiped wiped{*text};
  return parsePublicKey(*text, path.string());
}

Result<PublicKey> parsePublicKey(std::string_view text, const std::string& name) {
  return takeKey(text, kPublicWord, name, 1);
}

}  // namespace rocinante
