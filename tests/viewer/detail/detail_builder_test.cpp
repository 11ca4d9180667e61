#include "viewer/detail/detail_builder.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/detail/test_meshes.h"

namespace rocinante {
namespace {

using test::hillsMesh;
using test::inputOf;

class DetailInBackground : public testing::Test {
 protected:
  DetailInBackground() {
    for (int i = 0; i < 12; ++i) meshes_.push_back(hillsMesh(6 + 2 * i));
    for (const Mesh& mesh : meshes_) inputs_.push_back(inputOf(mesh));
  }
  std::vector<Mesh> meshes_;
  std::vector<DetailInput> inputs_;
};

TEST_F(DetailInBackground, IsTheSameWithAnyNumberOfThreadsAndFromTheCache) {
  const test::TemporaryFolder folder;
  for (const int threads : {1, 4}) {
    for (const bool cached : {false, true}) {
      const DetailCache cache = cached ? DetailCache(folder.path()) : DetailCache();
      DetailBuilder builder(inputs_, cache, threads);
      std::map<std::size_t, MeshDetail> made;
      for (ReadyDetail& one : builder.waitForAll()) {
        EXPECT_TRUE(made.emplace(one.number, std::move(one.detail)).second);
      }
      EXPECT_TRUE(builder.finished());
      ASSERT_EQ(made.size(), inputs_.size());
      for (std::size_t i = 0; i < inputs_.size(); ++i) {
        EXPECT_EQ(made[i], makeMeshDetail(inputs_[i])) << "mesh " << i;
      }
    }
  }
}

TEST_F(DetailInBackground, IsHandedOverOnce) {
  DetailBuilder builder(inputs_, {}, 2);
  std::size_t taken = builder.takeReady().size();
  taken += builder.waitForAll().size();
  EXPECT_EQ(taken, inputs_.size());
  EXPECT_TRUE(builder.takeReady().empty());
}

TEST_F(DetailInBackground, NobodyHasToWaitForIt) {
  { DetailBuilder left_alone(inputs_, {}, 2); }
  DetailBuilder nothing({}, {}, 4);
  EXPECT_TRUE(nothing.finished());
  EXPECT_TRUE(nothing.waitForAll().empty());
}

}  // namespace
}  // namespace rocinante
