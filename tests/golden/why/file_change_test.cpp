#include "golden/why/file_change.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocinante {
namespace {

using testing::ElementsAre;

TEST(FileChanges, NameWhatAFileIs) {
  EXPECT_THAT(fileChanges({{"a.obj", "1"}, {"a.mtl", "1"}, {"t.PNG", "1"}, {"same.stl", "1"}},
                          {{"a.obj", "2"}, {"a.mtl", "2"}, {"same.stl", "1"}, {"b.urdf", "1"}}),
              ElementsAre("a.mtl: the materials have changed", "a.obj: the mesh has changed",
                          "b.urdf: the kinematics is new",
                          "t.PNG: the texture is no longer part of the cell"));
}

}  // namespace
}  // namespace rocinante
