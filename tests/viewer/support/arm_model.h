#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/cell/cell.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante::test {

/// The arm of test_session.h as a window shows it at first, from files in `folder`: arm.urdf alone,
/// or, unless `more` is empty, a cell.toml with the device `arm` and then `more`.
inline std::unique_ptr<ViewModel> modelOfArm(const TemporaryFolder& folder,
                                             const std::string& more = {}) {
  writeText(folder / "arm.urdf", kArmUrdf);
  if (!more.empty()) {
    writeText(folder / "cell.toml",
              "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n" + more);
  }
  auto cell = loadCell(folder / (more.empty() ? "arm.urdf" : "cell.toml"), {});
  auto model = std::make_unique<ViewModel>(
      ViewModel::make(std::move(cell.value()), std::nullopt, std::nullopt, {}, {}).value());
  EXPECT_TRUE(model->update(SteadyTime{}).ok());
  return model;
}

}  // namespace rocinante::test
