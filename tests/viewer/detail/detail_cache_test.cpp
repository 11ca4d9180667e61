#include "viewer/detail/detail_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>

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
template <class Value>
Bytes forged(Bytes bytes, std::size_t at, Value value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
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

TEST_F(DetailCacheFiles, ForgedLengthsAreRefusedBeforeMemoryIsTaken) {
  const Bytes whole = encodeDetail(detail, key);
  constexpr std::uint64_t kLarge = std::uint64_t{1} << 60U;
  // The lengths of the key, of the parts and of the first part's versions.
  for (const std::size_t at : {16U, 56U, 64U}) {
    EXPECT_EQ(decodeDetail(forged(whole, at, kLarge), key, input), std::nullopt) << at;
    EXPECT_EQ(decodeDetail(forged(whole, at, whole.size() - at - 24), key, input), std::nullopt)
        << at;
  }
  const std::size_t indices_at = whole.size() - 16 - detail.indices.size() * 4 - 8;
  ASSERT_EQ(
      decodeDetail(forged(whole, indices_at, std::uint64_t{detail.indices.size()}), key, input),
      detail);
  for (const std::uint64_t count : {kLarge, std::uint64_t{detail.indices.size() + 1}}) {
    EXPECT_EQ(decodeDetail(forged(whole, indices_at, count), key, input), std::nullopt) << count;
  }
}

TEST_F(DetailCacheFiles, AnotherLayoutOrLibraryOrKeyIsAsNone) {
  const Bytes whole = encodeDetail(detail, key);
  constexpr std::size_t kLayoutAt = 8, kLibraryAt = 12;
  EXPECT_EQ(decodeDetail(forged(whole, 0, 'r'), key, input), std::nullopt);
  EXPECT_EQ(decodeDetail(forged(whole, kLayoutAt, std::uint32_t{1}), key, input), std::nullopt);
  EXPECT_EQ(decodeDetail(forged(whole, kLibraryAt, std::uint32_t{1}), key, input), std::nullopt);
  EXPECT_EQ(decodeDetail(whole, std::string(32, '0'), input), std::nullopt);
}

TEST_F(DetailCacheFiles, WhatDoesNotFitTheMeshIsAsNone) {
  ASSERT_FALSE(detail.parts[0].empty());
  using Versions = std::vector<CoarsePart>;
  const auto isRefused = [&](const std::function<void(MeshDetail&, Versions&)>& change) {
    MeshDetail changed = detail;
    change(changed, changed.parts[0]);
    return !decodeDetail(encodeDetail(changed, key), key, input);
  };
  EXPECT_FALSE(isRefused([](MeshDetail&, Versions&) {}));
  EXPECT_TRUE(isRefused([&](MeshDetail& its, Versions&) {
    its.indices.back() = static_cast<std::uint32_t>(mesh.vertices.size());
  }));
  EXPECT_TRUE(isRefused([](MeshDetail& its, Versions& versions) {
    versions[0].first_index = static_cast<std::uint32_t>(its.indices.size());
  }));
  EXPECT_TRUE(isRefused([](MeshDetail&, Versions& versions) {
    versions[0].first_index = 0xFFFF'FFFF;  // past 32 bits with the counts added
  }));
  EXPECT_TRUE(isRefused([](MeshDetail&, Versions& versions) { --versions[0].two_sided_count; }));
  EXPECT_TRUE(isRefused([](MeshDetail&, Versions& versions) {
    versions[0] = {versions[0].error_m, 0, 0, 1};
  }));
  EXPECT_TRUE(isRefused([](MeshDetail&, Versions& versions) { versions[0].error_m = -1; }));
  EXPECT_TRUE(isRefused([](MeshDetail&, Versions& versions) {
    versions[0].error_m = std::numeric_limits<double>::quiet_NaN();
  }));
  EXPECT_TRUE(isRefused([](MeshDetail&, Versions& versions) {
    versions.push_back(versions.back());
    versions.back().error_m /= 2;
  }));
  EXPECT_FALSE(isRefused(
      [](MeshDetail&, Versions& versions) { versions.assign(64, CoarsePart(versions.front())); }));
  EXPECT_TRUE(isRefused(
      [](MeshDetail&, Versions& versions) { versions.assign(65, CoarsePart(versions.front())); }));
  EXPECT_TRUE(isRefused([](MeshDetail& its, Versions&) { its.parts.pop_back(); }));
  EXPECT_TRUE(isRefused([](MeshDetail& its, Versions&) { its.parts.emplace_back(); }));
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
