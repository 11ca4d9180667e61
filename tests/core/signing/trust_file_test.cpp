#include "core/signing/trust_file.h"

#include <gtest/gtest.h>

#include "tests/core/signing/signing_support.h"

namespace rocinante {
namespace {

using test::vectorKey;

std::string tableOf(std::string_view rest) {
  return "[[key]]\npublic = \"" + std::string(test::kVectorPublic) + "\"\n" + std::string(rest);
}

std::string faultIn(std::string_view text) {
  const auto file = TrustFile::parse(text, "trusted.toml");
  return file ? "accepted" : file.error().text();
}

TEST(TrustFile, ListsKeysAndWhatTheyMaySay) {
  const auto file =
      TrustFile::parse(tableOf("sources = [\"arm\", \"left *\"]\n") + "[[key]]\npublic = \"" +
                           publicKeyText(vectorKey(1).publicKey()) + "\"\nrelay = true\n",
                       "trusted.toml");
  ASSERT_TRUE(file.ok()) << file.error().text();
  ASSERT_EQ(file->keys.size(), 2U);
  const TrustedKey* const key = file->find(vectorKey().id());
  ASSERT_NE(key, nullptr);
  EXPECT_EQ(key->sources, (std::vector<std::string>{"arm", "left *"}));
  EXPECT_FALSE(key->is_relay);
  EXPECT_TRUE(file->find(vectorKey(1).id())->is_relay);
  EXPECT_EQ(file->find(1), nullptr);
}

TEST(TrustFile, WhatIsWrittenReadsBack) {
  const SigningKey key = vectorKey();
  const TrustedKey given{key.id(), key.publicKey(), {"a \"b\" \\ \t*", "m\xC3\xA9"}, true};
  const auto file = TrustFile::parse(trustText(given), "t");
  ASSERT_TRUE(file.ok()) << file.error().text();
  EXPECT_EQ(file->keys.front().sources, given.sources);
  EXPECT_TRUE(file->keys.front().is_relay);
}

TEST(TrustFile, SaysWhereItIsWrong) {
  EXPECT_EQ(faultIn(""), "the file lists no [[key]] (trusted.toml:1:1)");
  EXPECT_EQ(faultIn(tableOf("")),
            "this key may say nothing: it needs `sources` or `relay = true` (trusted.toml:1:1)");
  EXPECT_EQ(faultIn("[[key]]\npublic = \"abc\"\nsources = [\"*\"]\n"),
            "a public key must be 44 characters of base64 (trusted.toml:2:10)");
  EXPECT_EQ(faultIn("[[key]]\nsources = [\"*\"]\n"), "[[key]] lacks `public` (trusted.toml:1:1)");
  EXPECT_EQ(faultIn(tableOf("sources = [\"*\"]\n") + tableOf("sources = [\"*\"]\n")),
            "key 9d24e2eeaf27c2a0 is listed twice (trusted.toml:5:10)");
  EXPECT_EQ(faultIn(tableOf("sources = [\"\"]\n")),
            "a pattern must not be empty (trusted.toml:3:11)");
  EXPECT_NE(faultIn(tableOf("source = [\"*\"]\n")).find("sources"), std::string::npos);
  EXPECT_NE(faultIn(tableOf("sources = 3\n")), "accepted");
  EXPECT_NE(faultIn("[[key"), "accepted");
}

TEST(TrustFile, HasABoundedNumberOfKeys) {
  std::string text;
  for (int i = 0; i < 1025; ++i) text += tableOf("relay = true\n");
  EXPECT_NE(faultIn(text).find("more than 1024 keys"), std::string::npos);
}

}  // namespace
}  // namespace rocinante
