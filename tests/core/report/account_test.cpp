#include "core/report/account.h"

#include <gtest/gtest.h>

#include "core/document/fault_list.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

TEST(Account, CountsTheSameThingOnceAndKeepsItsFirstPlace) {
  Account account;
  account.leaveOut({.kind = "topic", .name = "/camera", .reason = "pictures are not read"});
  account.leaveOut({.kind = "row", .reason = "no time", .first = "row 3"});
  account.leaveOut({.kind = "row", .reason = "no time", .first = "row 9", .count = 4});
  ASSERT_EQ(account.leftOut().size(), 2U);
  EXPECT_EQ(account.leftOut()[1].count, 5U);
  EXPECT_EQ(account.total(), 6U);
  EXPECT_EQ(
      accountSentence(account),
      "left out: 1 topic `/camera` (pictures are not read), 5 rows (no time; the first at row 3)");
  EXPECT_EQ(accountSentence(account, 1),
            "left out: 1 topic `/camera` (pictures are not read), and 5 things more");
  EXPECT_EQ(accountBrief(account), "1 `/camera`, 5 rows are left out");
  EXPECT_EQ(accountBrief(account, 1), "1 `/camera` and 5 things more are left out");
  EXPECT_EQ(accountBrief({}), "");
}

TEST(Account, OfNothingSaysNothing) {
  EXPECT_EQ(accountSentence({}), "");
  EXPECT_EQ(leftOutJson({}).dump(), R"({"total":0,"unlisted":0,"items":[]})");
}

TEST(Account, IsBoundedAndCountsWhatItDoesNotList) {
  Account account;
  for (int i = 0; i < 1000; ++i) account.leaveOut({.kind = "column", .name = std::to_string(i)});
  EXPECT_EQ(account.leftOut().size(), Account::kMaxListed);
  EXPECT_EQ(account.total(), 1000U);
  EXPECT_EQ(account.unlisted(), 1000 - Account::kMaxListed);
  Account twice = account;
  twice.add(account);
  EXPECT_EQ(twice.total(), 2000U);
  EXPECT_EQ(leftOutJson(twice)["unlisted"], 2 * (1000 - Account::kMaxListed));
}

TEST(Account, OfAModelIsWhatItsFindingsLeftOut) {
  Findings findings;
  {
    FaultList faults(findings, "arm.glb");
    faults.warning("mesh.missing-texture", {}, "no picture");
    faults.leaveOut("extension", "EXT_mesh_gpu_instancing", {}, "instances are not drawn");
    faults.leaveOut("element", "pbr", {12, 3}, "maps of <pbr> are not drawn", Severity::warning);
    faults.leaveOut("element", "pbr", {40, 3}, "maps of <pbr> are not drawn", Severity::warning);
  }
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_EQ(findings[2].print(),
            "arm.glb:12:3: warning: element `pbr` is left out 2 times: maps of <pbr> are not drawn "
            "[model.left-out]");
  EXPECT_EQ(leftOutJson(accountOf(findings))["items"][1].dump(),
            R"({"kind":"element","name":"pbr","reason":"maps of <pbr> are not drawn",)"
            R"("first":"arm.glb:12:3","count":2,"severity":"warning"})");
}

}  // namespace
}  // namespace rocinante
