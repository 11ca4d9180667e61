#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/check/check.h"
#include "core/check/session_check.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {

inline constexpr std::string_view kCheckedArm = R"(<robot name="arm">
  <link name="base"/> <link name="upper"/> <link name="lower"/> <link name="hand"/> <link name="tip"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-1" upper="1.5" effort="1" velocity="1"/> </joint>
  <joint name="elbow" type="continuous"> <parent link="upper"/> <child link="lower"/> </joint>
  <joint name="slide" type="prismatic"> <parent link="lower"/> <child link="hand"/>
    <limit lower="0" upper="0.2" effort="1" velocity="1"/> </joint>
  <joint name="weld" type="fixed"> <parent link="hand"/> <child link="tip"/> </joint>
</robot>)";

inline constexpr std::string_view kCheckedCell = R"(format = 1
search = ["."]
[[device]]
name = "arm"
model = "arm.urdf"
layer = "robots"
[[device]]
name = "spare"
model = "arm.urdf"
optional = true
)";

/// A test cell and the datagrams of a session.
class SessionCheckTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "arm.urdf") << kCheckedArm;
    std::ofstream(folder_ / "cell.toml") << kCheckedCell;
    Result<Cell> cell = loadCell(folder_ / "cell.toml", {});
    ASSERT_TRUE(cell.ok()) << cell.error().text();
    cell_ = std::move(*cell);
    for (const Finding& fault : cell_.faults) ADD_FAILURE() << fault.print();
    session_.emplace(cell_);
  }

  /// One datagram of packet text, a millisecond after the one before.
  void say(std::string_view header, std::string_view statements) {
    now_ += std::chrono::milliseconds(1);
    session_->add(now_, "rk1", true, bytesOf(fmt::format("RK1 {}\n{}\n", header, statements)));
  }
  void say(std::string_view statements) { say("me - -", statements); }

  CheckReport report() { return checkSession(cell_, *session_); }

  static std::vector<std::string> rules(const CheckReport& report) {
    std::vector<std::string> rules;
    for (const Finding& finding : report.findings) rules.push_back(finding.rule);
    return rules;
  }

  const TemporaryFolder folder_;
  Cell cell_;
  std::optional<SessionCheck> session_;
  LogTime now_{std::chrono::seconds(1000)};
};

}  // namespace rocinante::test
