#include "viewer/page/page_file.h"

#include <gtest/gtest.h>

#include "core/base/base64.h"
#include "core/base/hash.h"

namespace rocinante {
namespace {

Bytes bytesFrom(std::string_view text) {
  const ByteView view = bytesOf(text);
  return Bytes(view.begin(), view.end());
}

PageParts smallParts() {
  PageParts parts;
  parts.title = "session.mcap";
  parts.viewer_script = "var rocinanteViewer = 1;  // </script><script>\n";
  parts.viewer = bytesFrom(std::string("\0asm", 4) + std::string(200, 'w'));
  parts.cell = bytesFrom("a baked cell");
  parts.log = bytesFrom(std::string("\x89MCAP0\r\n", 8) + std::string(50, '\xFF'));
  return parts;
}

TEST(PageFile, CarriesItsLogByteForByte) {
  constexpr std::size_t kPiece = 48U << 10U;
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{4},
        std::size_t{1000}, kPiece - 1, kPiece, kPiece + 1, 2 * kPiece, 3 * kPiece + 7}) {
    SCOPED_TRACE(size);
    PageParts parts = smallParts();
    for (std::size_t i = 0; i < size; ++i) parts.log.push_back(std::byte(i * 7 % 251));
    const auto log = logOfPage(pageOf(parts), "page.html");
    ASSERT_TRUE(log.has_value()) << log.error().text();
    EXPECT_EQ(*log, parts.log);
  }
}

TEST(PageFile, ItsPiecesAreInThePageInOrder) {
  PageParts parts = smallParts();
  parts.log.assign(100'000, std::byte{0});
  const std::string page = pageOf(parts);
  const std::string piece(65536, 'A');
  EXPECT_NE(page.find("data-bytes=\"100000\">" + piece +
                      "</script>\n<script type=\"text/plain\" data-more>" + piece + "</script>\n"),
            std::string::npos);
}

TEST(PageFile, GivesTheLogOfAPageOfTheFirstVersion) {
  const std::string page =
      "<!DOCTYPE html>\n<!-- rocinante page 1 -->\n<html>"
      "\n<script type=\"text/plain\" id=\"rocinante-log\" "
      "data-xxh3=\"" +
      hexOf(xxh3(bytesOf("foobar"))) + "\">Zm9vYmFy</script>\n</body>";
  const auto log = logOfPage(page, "old.html");
  ASSERT_TRUE(log.has_value()) << log.error().text();
  EXPECT_EQ(*log, bytesFrom("foobar"));
}

TEST(PageFile, ALogOfAnotherSizeThanItSaysIsRefused) {
  std::string page = pageOf(smallParts());
  const std::size_t at = page.find("data-bytes=\"58\"");
  ASSERT_NE(at, std::string::npos);
  page.replace(at, 15, "data-bytes=\"59\"");
  const auto log = logOfPage(page, "page.html");
  ASSERT_FALSE(log.has_value());
  EXPECT_EQ(log.error().kind, ErrorKind::damaged);
}

TEST(PageFile, IsTheSameForTheSameParts) { EXPECT_EQ(pageOf(smallParts()), pageOf(smallParts())); }

TEST(PageFile, LoadsNothingAndSaysSo) {
  const std::string page = pageOf(smallParts());
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (const char* const loads : {"http:", "https:", " src=", "@import", "url("}) {
    EXPECT_EQ(page.find(loads), std::string::npos) << loads;
  }
}

TEST(PageFile, ANameIsTextAndNothingElse) {
  PageParts parts = smallParts();
  parts.title = "</title><script>alert(\"1\")</script>{{data}}{{script}}";
  const std::string page = pageOf(parts);
  EXPECT_EQ(page.find("alert(\"1\")"), std::string::npos);
  EXPECT_NE(page.find("&#123;&#123;data}}&#123;&#123;script}}</title>"), std::string::npos);
  const auto log = logOfPage(page, "page.html");
  ASSERT_TRUE(log.has_value()) << log.error().text();
  EXPECT_EQ(*log, parts.log);
}

TEST(PageFile, HasALayoutWhereOneIsGiven) {
  PageParts parts = smallParts();
  EXPECT_EQ(pageOf(parts).find("id=\"rocinante-layout\""), std::string::npos);
  parts.layout = "{}";
  const std::string page = pageOf(parts);
  EXPECT_LT(page.find("id=\"rocinante-layout\""), page.find("id=\"rocinante-log\""));
  EXPECT_EQ(*logOfPage(page, "page.html"), parts.log);
}

TEST(PageFile, IsInTheThemeThatIsAskedFor) {
  PageParts parts = smallParts();
  const auto has = [&](const char* text) { return pageOf(parts).find(text) != std::string::npos; };
  EXPECT_TRUE(has("color-scheme: light dark;"));
  EXPECT_TRUE(has("@media (prefers-color-scheme: dark) {"));
  parts.is_light = false;
  EXPECT_TRUE(has("color-scheme: dark;"));
  EXPECT_TRUE(has("@media all {"));
  parts.is_light = true;
  EXPECT_TRUE(has("color-scheme: light;"));
  EXPECT_TRUE(has("@media not all {"));
  EXPECT_FALSE(has("prefers-color-scheme"));
}

TEST(PageFile, NothingOfAPartEndsIt) {
  const std::string page = pageOf(smallParts());
  // Six parts and the page's own script.
  std::size_t ends = 0;
  for (std::size_t at = page.find("</script>"); at != std::string::npos;
       at = page.find("</script>", at + 1)) {
    ++ends;
  }
  EXPECT_EQ(ends, 7U);
}

TEST(PageFile, APageThatWasCutOrChangedGivesNoLog) {
  const std::string page = pageOf(smallParts());
  const std::size_t log_ends = page.find("</script>", page.find("id=\"rocinante-log\""));
  for (std::size_t size = 0; size <= log_ends; ++size) {
    const std::string cut = page.substr(0, size);
    EXPECT_FALSE(logOfPage(cut, "page.html").has_value()) << size;
  }
  const std::size_t log_begins = page.find("id=\"rocinante-log\"");
  for (std::size_t at = log_begins + 18; at < log_ends; ++at) {
    std::string changed = page;
    changed[at] = changed[at] == 'B' ? 'C' : 'B';
    EXPECT_FALSE(logOfPage(changed, "page.html").has_value()) << at;
  }
}

TEST(PageFile, OtherFilesAreRefusedByName) {
  for (const char* const text : {"", "<!DOCTYPE html>\n<p>hello", "\x89MCAP0\r\n"}) {
    const auto log = logOfPage(text, "some.html");
    ASSERT_FALSE(log.has_value());
    EXPECT_EQ(log.error().kind, ErrorKind::unsupported);
    EXPECT_EQ(log.error().where, "some.html");
  }
}

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(base64Of(bytesOf("")), "");
  EXPECT_EQ(base64Of(bytesOf("f")), "Zg==");
  EXPECT_EQ(base64Of(bytesOf("foobar")), "Zm9vYmFy");
  EXPECT_EQ(bytesOfBase64("Zm9vYmFy"), bytesFrom("foobar"));
  for (const char* const text :
       {"Zg", "Zg=", "Zh==", "Zg==\n", " Zg==", "Zm9v!", "=", "\xda\x67=="}) {
    EXPECT_FALSE(bytesOfBase64(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace rocinante
