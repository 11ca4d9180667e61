// docs/signing.md shows the vector that the other tests use.
#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "tests/core/signing/signing_support.h"

namespace rocinante {
namespace {

std::string documentText() {
  return readFile(std::filesystem::path(ROCINANTE_SOURCE_DIR) / "docs" / "signing.md").value();
}

TEST(SigningDocument, ShowsTheVector) {
  const std::string text = documentText();
  const std::string signed_block = "```signed\n" + std::string(test::kSignedPacket) + "```\n";
  const std::string plain_block = "```\n" + std::string(test::kUnsignedPacket) + "```\n";
  EXPECT_NE(text.find(signed_block), std::string::npos);
  EXPECT_NE(text.find(plain_block), std::string::npos);
  EXPECT_NE(text.find(test::kVectorPublic), std::string::npos);
  EXPECT_NE(text.find(std::to_string(kSignatureBytes) + " bytes"), std::string::npos);
}

TEST(SigningDocument, ItsTrustFileIsOne) {
  const std::string text = documentText();
  const std::size_t begin = text.find("[[key]]");
  ASSERT_NE(begin, std::string::npos);
  const auto trust =
      TrustFile::parse(text.substr(begin, text.find("```", begin) - begin), "docs/signing.md");
  ASSERT_TRUE(trust.ok()) << trust.error().text();
  EXPECT_EQ(trust->keys.size(), 2U);
}

TEST(SigningDocument, NamesEveryReason) {
  const std::string text = documentText();
  for (std::size_t i = 0; i < kUntrustedReasons; ++i) {
    const std::string name(nameOf(static_cast<Untrusted>(i)));
    EXPECT_NE(text.find("| `" + name + "` |"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace rocinante
