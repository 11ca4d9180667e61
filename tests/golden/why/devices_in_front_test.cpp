#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mesh/shapes.h"
#include "golden/why/run_pictures.h"
#include "tests/viewer/support/test_scene.h"

namespace rocinante {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> inFrontOf(const std::string& device, Cell cell) {
  auto maker = FrameMaker::open(std::move(cell), std::nullopt, Profile::reproducible);
  if (!maker.ok()) throw std::runtime_error(maker.error().text());
  FrameRequest request;
  request.camera = "fit:" + device;
  request.width = 160;
  request.height = 100;
  auto found = devicesInFront(*maker, request, device);
  if (!found.ok()) throw std::runtime_error(found.error().text());
  return *found;
}

TEST(DevicesInFront, WhatCoversTheDeviceIsNamed) {
  test::TestCell cell;
  cell.add("part", boxMesh({0.2, 0.2, 0.2}), {0, 0, 0});
  cell.add("far", boxMesh({0.2, 0.2, 0.2}), {20, 20, 0});
  cell.add("hood", boxMesh({0.4, 0.4, 0.4}), {0, 0, 0});
  EXPECT_THAT(inFrontOf("part", cell.cell()), ElementsAre("hood"));
  EXPECT_THAT(inFrontOf("hood", cell.cell()), IsEmpty());
  EXPECT_THAT(inFrontOf("far", cell.cell()), IsEmpty());
}

TEST(DevicesInFront, AHalfThatIsSeenIsEnough) {
  test::TestCell cell;
  cell.add("part", boxMesh({0.2, 0.2, 0.2}), {0, 0, 0});
  cell.add("low", boxMesh({0.4, 0.4, 0.1}), {0, 0, -0.1});
  EXPECT_THAT(inFrontOf("part", cell.cell()), IsEmpty());
}

}  // namespace
}  // namespace rocinante
