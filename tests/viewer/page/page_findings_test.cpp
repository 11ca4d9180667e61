#include <gtest/gtest.h>

#include "viewer/page/page_parts.h"

namespace rocinante {
namespace {

LogTime at(std::int64_t ns) { return LogTime(Nanoseconds(ns)); }

CheckReport reportWith(Finding finding) {
  CheckReport report;
  report.origin = at(1000);
  report.findings = {std::move(finding)};
  return report;
}

TEST(PageFindings, TimesAreFromTheOrigin) {
  Finding finding;
  finding.rule = "joint.beyond-limit";
  finding.text = "joint `a` is beyond its limit";
  finding.subject = "arm";
  finding.first = at(3500);
  finding.last = at(4000);
  finding.count = 7;
  EXPECT_EQ(pageFindings(reportWith(finding)),
            "[{\"severity\":\"error\",\"rule\":\"joint.beyond-limit\","
            "\"text\":\"joint `a` is beyond its limit\",\"count\":7,\"subject\":\"arm\","
            "\"first_ns\":2500,\"last_ns\":3000}]");
}

TEST(PageFindings, GiveNoFolderAway) {
  Finding finding;
  finding.rule = "model.no-mesh";
  finding.text = "cannot read /home/ada/secret/arm.urdf";
  finding.hint = "look into /home/ada/secret/arm.urdf";
  finding.file = "/home/ada/secret/arm.urdf";
  const std::string text = pageFindings(reportWith(finding));
  EXPECT_EQ(text.find("secret"), std::string::npos) << text;
  EXPECT_NE(text.find("cannot read arm.urdf"), std::string::npos) << text;
}

TEST(PageFindings, AcceptedOnesAreLeftOut) {
  Finding finding;
  finding.accepted = true;
  EXPECT_EQ(pageFindings(reportWith(finding)), "[]");
}

}  // namespace
}  // namespace rocinante
