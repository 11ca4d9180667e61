#include "core/signing/signing_key.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "core/base/atomic_file.h"
#include "tests/core/signing/signing_support.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::kVectorId;
using test::kVectorPublic;
using test::kVectorSecret;
using test::vectorKey;

std::string keyText() {
  return "rocinante-public " + std::string(kVectorPublic) + "\nrocinante-secret " +
         std::string(kVectorSecret) + "\n";
}

std::string refusalOf(std::string_view text) {
  const auto key = SigningKey::parse(text, "k");
  return key ? "accepted" : key.error().text();
}

TEST(SigningKey, HasTheBytesOfTheVector) {
  const SigningKey key = vectorKey();
  EXPECT_EQ(publicKeyText(key.publicKey()), kVectorPublic);
  EXPECT_EQ(keyIdText(key.id()), kVectorId);
}

TEST(SigningKey, IsWrittenAndReadBackAndOnlyItsOwnerMayReadIt) {
  const test::TemporaryFolder folder;
  const auto path = folder / "arm.key";
  ASSERT_TRUE(vectorKey().write(path).ok());
  EXPECT_EQ(readFile(path).value(), keyText());
  EXPECT_EQ(readFile(folder / "arm.key.pub").value(),
            "rocinante-public " + std::string(kVectorPublic) + "\n");
  struct stat facts {};
  ASSERT_EQ(::stat(path.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777U, 0600U);
  EXPECT_EQ(SigningKey::read(path).value().id(), vectorKey().id());
  EXPECT_EQ(readPublicKey(folder / "arm.key.pub").value(), vectorKey().publicKey());
}

TEST(SigningKey, IsRefusedWhenOthersMayReadIt) {
  const test::TemporaryFolder folder;
  const auto path = folder / "arm.key";
  ASSERT_TRUE(vectorKey().write(path).ok());
  for (const mode_t mode : {0640U, 0604U, 0620U, 0601U}) {
    SCOPED_TRACE(mode);
    ASSERT_EQ(::chmod(path.c_str(), mode), 0);
    const auto key = SigningKey::read(path);
    ASSERT_FALSE(key.ok());
    EXPECT_EQ(key.error().kind, ErrorKind::refused);
    EXPECT_NE(key.error().text().find("chmod 600"), std::string::npos);
  }
}

TEST(SigningKey, IsNeverReplaced) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(vectorKey().write(folder / "a").ok());
  EXPECT_FALSE(SigningKey::make().write(folder / "a").ok());
  EXPECT_EQ(readFile(folder / "a").value(), keyText());
  // A secret file without its public one: nothing is left behind.
  std::filesystem::remove(folder / "a.pub");
  EXPECT_FALSE(SigningKey::make().write(folder / "a").ok());
  EXPECT_FALSE(std::filesystem::exists(folder / "a.pub"));
}

TEST(SigningKey, TwoNewOnesDiffer) {
  EXPECT_NE(SigningKey::make().publicKey(), SigningKey::make().publicKey());
}

TEST(SigningKey, SaysWhereAFileIsMalformed) {
  EXPECT_EQ(refusalOf(keyText()), "accepted");
  EXPECT_EQ(refusalOf(""),
            "the line must be `rocinante-public ` and 44 characters of base64 (k, line 1)");
  const std::string public_line = "rocinante-public " + std::string(kVectorPublic) + "\n";
  EXPECT_EQ(refusalOf(public_line), "the secret line is missing: this is a public key (k, line 2)");
  EXPECT_EQ(refusalOf(public_line + "rocinante-secret " + std::string(kVectorPublic) + "\n"),
            "the public and the secret line do not belong together (k, line 2)");
  EXPECT_EQ(refusalOf(keyText() + "\n"), "a key file has two lines (k, line 3)");
}

TEST(SigningKey, EveryCutOfAFileIsRefused) {
  const std::string whole = keyText();
  for (std::size_t bytes = 0; bytes + 1 < whole.size(); ++bytes) {
    const std::string cut = whole.substr(0, bytes);
    EXPECT_NE(refusalOf(cut), "accepted") << bytes;
  }
}

TEST(SigningKey, ASignatureIsOfOneKeyAndItsBytes) {
  const SigningKey key = vectorKey();
  const Signature signature = key.sign(bytesOf("abc"));
  EXPECT_TRUE(isSignatureOf(key.publicKey(), bytesOf("abc"), signature));
  EXPECT_FALSE(isSignatureOf(key.publicKey(), bytesOf("abd"), signature));
  EXPECT_FALSE(isSignatureOf(vectorKey(1).publicKey(), bytesOf("abc"), signature));
}

}  // namespace
}  // namespace rocinante
