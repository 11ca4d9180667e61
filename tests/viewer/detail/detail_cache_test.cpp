#include "viewer/detail/detail_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/detail/test_meshes.h"

namespace rocinante {
namespace {

using test::hillsMesh;
using test::inputOf;

class DetailCacheFiles : public testing::Test {
 protected:
  std::filesystem::path fileOf(const std::string& name) const {
    return (folder / name).replace_extension(".lod");
  }

  const test::TemporaryFolder folder;
  const Mesh mesh = hillsMesh(20, 2);
  const DetailInput input = inputOf(mesh);
  const std::string key = detailKey(input);
  const MeshDetail detail = makeMeshDetail(input);
};

TEST_F(DetailCacheFiles, GiveBackWhatWasStored) {
  const DetailCache cache(folder / "deep" / "down");
  EXPECT_EQ(cache.load(key, input), std::nullopt);
  cache.store(key, detail);
  EXPECT_EQ(cache.load(key, input), detail);
}

TEST_F(DetailCacheFiles, AnyFlippedBitAndAnyCutIsAsNone) {
  const Bytes whole = encodeDetail(detail, key);
  ASSERT_EQ(decodeDetail(whole, key, input), detail);
  // Every byte of the header and the parts, then some of the indices.
  for (std::size_t i = 0; i < whole.size(); i += i < 300 ? 1 : 97) {
    Bytes damaged = whole;
    damaged[i] ^= std::byte{16};
    EXPECT_EQ(decodeDetail(damaged, key, input), std::nullopt) << "byte " << i;
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(decodeDetail(cut, key, input), std::nullopt) << "cut at " << i;
  }
}

/// With its checksum made right again: what a hostile hand would do.
Bytes forged(Bytes bytes, std::size_t at, std::byte value) {
  bytes[at] = value;
  const auto hash = xxh3(ByteView(bytes).first(bytes.size() - 16));
  std::copy(hash.begin(), hash.end(), bytes.end() - 16);
  return bytes;
}

TEST_F(DetailCacheFiles, ForgedNumbersNeverReachTheDriver) {
  const Bytes whole = encodeDetail(detail, key);
  for (std::size_t i = 0; i + 16 < whole.size(); i += i < 300 ? 1 : 97) {
    for (const std::byte value : {std::byte{0xFF}, std::byte{0x7F}, std::byte{0}}) {
      const auto read = decodeDetail(forged(whole, i, value), key, input);
      if (!read) continue;
      for (const std::uint32_t index : read->indices) ASSERT_LT(index, mesh.vertices.size());
      for (const auto& versions : read->parts) {
        for (const CoarsePart& part : versions) {
          ASSERT_LE(std::uint64_t{part.first_index} + part.two_sided_count + part.one_sided_count,
                    read->indices.size());
        }
      }
    }
  }
}

TEST_F(DetailCacheFiles, AnotherMeshUnderThisNameIsAsNone) {
  const DetailCache cache(folder.path());
  cache.store(key, detail);
  const Mesh other = hillsMesh(24, 2);
  const std::string other_key = detailKey(inputOf(other));
  std::filesystem::rename(fileOf(key), fileOf(other_key));
  EXPECT_EQ(cache.load(other_key, inputOf(other)), std::nullopt);
  cache.store(other_key, makeMeshDetail(inputOf(other)));
  EXPECT_NE(cache.load(other_key, inputOf(other)), std::nullopt);
}

TEST_F(DetailCacheFiles, TheLongestUnusedGoWhenItIsFull) {
  const std::uint64_t size = encodeDetail(detail, key).size();
  const DetailCache cache(folder.path(), size * 5 / 2);
  std::ofstream(folder / "not ours.lod") << std::string(2 * size, 'x');
  const auto named = [&](char digit) { return std::string(32, digit); };
  const auto age = [&](char digit, int hours) {
    std::filesystem::last_write_time(
        fileOf(named(digit)),
        std::filesystem::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  cache.store(named('a'), detail);
  age('a', 3);
  cache.store(named('b'), detail);
  age('b', 2);
  EXPECT_NE(cache.load(named('a'), input), std::nullopt);  // used again: now b is the oldest
  cache.store(named('c'), detail);
  EXPECT_TRUE(std::filesystem::exists(fileOf(named('a'))));
  EXPECT_FALSE(std::filesystem::exists(fileOf(named('b'))));
  EXPECT_TRUE(std::filesystem::exists(fileOf(named('c'))));
  EXPECT_TRUE(std::filesystem::exists(folder / "not ours.lod"));
}

TEST_F(DetailCacheFiles, WhatIsLargerThanTheCacheIsNotKept) {
  const DetailCache cache(folder.path(), 100);
  cache.store(key, detail);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(DetailCacheFiles, APlaceThatCannotBeWrittenIsNoTrouble) {
  std::ofstream(folder / "file") << "in the way";
  const DetailCache blocked(folder / "file" / "lod");
  blocked.store(key, detail);
  EXPECT_EQ(blocked.load(key, input), std::nullopt);
  const DetailCache none;
  none.store(key, detail);
  EXPECT_EQ(none.load(key, input), std::nullopt);
  // As /proc is for everybody, root too: readable, never writable.
  const DetailCache refused("/proc/rocinante");
  refused.store(key, detail);
  EXPECT_EQ(refused.load(key, input), std::nullopt);
}

TEST(DetailCacheOfUser, FollowsTheDirectoriesOfTheDesktop) {
  const char* const home = std::getenv("HOME");
  const std::string home_before = home != nullptr ? home : "";
  ::setenv("XDG_CACHE_HOME", "/somewhere/cache", 1);
  EXPECT_EQ(DetailCache::ofUser().folder(), "/somewhere/cache/rocinante/lod");
  ::setenv("XDG_CACHE_HOME", "relative", 1);  // to be ignored, says the specification
  ::setenv("HOME", "/home/dora", 1);
  EXPECT_EQ(DetailCache::ofUser().folder(), "/home/dora/.cache/rocinante/lod");
  ::unsetenv("XDG_CACHE_HOME");
  ::unsetenv("HOME");
  EXPECT_TRUE(DetailCache::ofUser().folder().empty());
  ::setenv("HOME", home_before.c_str(), 1);
}

}  // namespace
}  // namespace rocinante
