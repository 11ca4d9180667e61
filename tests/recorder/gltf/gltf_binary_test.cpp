#include "recorder/gltf/gltf_binary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mesh/glb_container.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

Status giveText(const UseBytes& use, std::string_view text) { return use(bytesOf(text)); }

TEST(GltfBinary, SectionsBeginAtMultiplesOfFour) {
  GltfBinary binary;
  binary.addView(3, GltfBinary::Target::none, 0,
                 [](const UseBytes& use) { return giveText(use, "abc"); });
  const std::size_t view = binary.addView(
      4, GltfBinary::Target::indices, 0, [](const UseBytes& use) { return giveText(use, "defg"); });
  binary.addAccessor(view, 0, kGltfUint32, "SCALAR", 1);
  Json document;
  binary.describe(document);
  Bytes glb;
  const auto sink = makeMemorySink(glb);
  ASSERT_TRUE(binary.write(*sink, document).ok());
  const auto parts = gltfParts(glb);
  ASSERT_TRUE(parts.ok());
  EXPECT_EQ(textOf(parts->binary), std::string_view("abc\0defg", 8));
  const Json read = Json::parse(parts->text);
  EXPECT_EQ(read["bufferViews"][1]["byteOffset"], 4);
  EXPECT_EQ(read["bufferViews"][1]["target"], 34963);
  EXPECT_EQ(read["buffers"][0]["byteLength"], 8);
  EXPECT_EQ(glb.size() % 4, 0U);
}

TEST(GltfBinary, NothingIsWrittenBeyondTwoGigabytes) {
  GltfBinary binary;
  binary.addView(std::uint64_t{3} << 30, GltfBinary::Target::none, 0,
                 [](const UseBytes&) -> Status {
                   ADD_FAILURE() << "asked for the bytes";
                   return {};
                 });
  Json document;
  binary.describe(document);
  Bytes glb;
  const auto sink = makeMemorySink(glb);
  const Status written = binary.write(*sink, document);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::unsupported);
  EXPECT_THAT(written.error().what, testing::HasSubstr("--every"));
  EXPECT_TRUE(glb.empty());
}

TEST(GltfBinary, ASectionThatGivesAnotherSizeIsRefused) {
  GltfBinary binary;
  binary.addView(5, GltfBinary::Target::none, 0,
                 [](const UseBytes& use) { return giveText(use, "abc"); });
  Json document;
  binary.describe(document);
  Bytes glb;
  const auto sink = makeMemorySink(glb);
  EXPECT_FALSE(binary.write(*sink, document).ok());
}

TEST(GlbContainer, AHeadWithoutABinaryChunkIsAWholeFile) {
  const Bytes glb = glbHead("{}", 0);
  ASSERT_EQ(glb, glbOf({"{}", {}}));
  const auto parts = gltfParts(glb);
  ASSERT_TRUE(parts.ok());
  EXPECT_EQ(parts->text, "{}  ");
  EXPECT_TRUE(parts->binary.empty());
}

}  // namespace
}  // namespace rocinante
