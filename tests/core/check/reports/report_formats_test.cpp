#include "core/check/reports/report_formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/check/reports/baseline.h"
#include "core/check/reports/time_strip.h"
#include "core/check/rules/rule_list.h"
#include "core/check/rules/rule_page.h"

namespace rocinante {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

constexpr LogTime kReportOrigin{std::chrono::seconds(1000)};

Finding findingOf(std::string rule, Severity severity, std::string text) {
  Finding finding;
  finding.rule = std::move(rule);
  finding.severity = severity;
  finding.text = std::move(text);
  return finding;
}

/// A session with an error of a malicious sender, and a warning and a note of the model.
CheckReport hostileReport() {
  CheckReport report;
  report.cell = "cells/a b.cell.toml";
  report.session = "session.mcap";
  report.has_session = true;
  report.packets = report.datagrams = 100;
  report.origin = kReportOrigin;
  report.duration = std::chrono::seconds(10);
  Finding finding = findingOf("packet.unknown-device", Severity::error,
                              "no <device> \"a&b\" ]]> %0A::error::x\n::stop\x01\xFF");
  finding.subject = "a,b:c%\x1B[31m";
  finding.count = 50;
  finding.first = kReportOrigin + std::chrono::seconds(2);
  finding.last = kReportOrigin + std::chrono::seconds(9);
  for (int i = 0; i < 50; ++i)
    finding.when.hit(*finding.first + std::chrono::milliseconds(i * 140));
  finding.packet = 21;
  finding.example = "joints \xC3\x28 1";
  report.findings.push_back(finding);
  Finding fault = findingOf("obj.bad-face", Severity::warning, "a face of 2 corners");
  fault.file = "/models/a b,c:d.obj";
  fault.line = 7;
  fault.column = 3;
  report.findings.push_back(fault);
  report.findings.push_back(findingOf("source.restart", Severity::note, "restarts of source me"));
  conclude(report);
  return report;
}

/// The elements and attributes of the schema that Jenkins' xUnit plugin enforces.
void expectJunitElement(const tinyxml2::XMLElement& element) {
  static const std::map<std::string, std::set<std::string>> kAttributes = {
      {"testsuites", {"name", "time", "tests", "failures", "disabled", "errors"}},
      {"testsuite",
       {"name", "tests", "failures", "errors", "time", "disabled", "skipped", "timestamp",
        "hostname", "id", "package"}},
      {"testcase", {"name", "assertions", "time", "classname", "status"}},
      {"failure", {"type", "message"}},
      {"error", {"type", "message"}},
      {"skipped", {"type", "message"}},
      {"system-out", {}}};
  const auto known = kAttributes.find(element.Name());
  ASSERT_NE(known, kAttributes.end()) << element.Name();
  for (const auto* each = element.FirstAttribute(); each != nullptr; each = each->Next()) {
    EXPECT_TRUE(known->second.contains(each->Name())) << element.Name() << " " << each->Name();
  }
  for (const auto* each = element.FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    expectJunitElement(*each);
  }
}

TEST(CheckJunit, IsWhatJenkinsReadsHoweverHostileTheSession) {
  tinyxml2::XMLDocument document;
  const std::string text = checkJunit(hostileReport());
  ASSERT_EQ(document.Parse(text.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  const auto* suites = document.RootElement();
  ASSERT_STREQ(suites->Name(), "testsuites");
  expectJunitElement(*suites);
  const auto* suite = suites->FirstChildElement("testsuite");
  ASSERT_NE(suite, nullptr);
  EXPECT_NE(suite->Attribute("name"), nullptr);
  int cases = 0, failures = 0, errors = 0;
  for (const auto* each = suite->FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    ASSERT_STREQ(each->Name(), "testcase");
    EXPECT_NE(each->Attribute("classname"), nullptr);
    EXPECT_NE(each->Attribute("name"), nullptr);
    ++cases;
    failures += each->FirstChildElement("failure") != nullptr;
    errors += each->FirstChildElement("error") != nullptr;
    // The schema demands this order: skipped, error or failure, then system-out.
    if (const auto* out = each->FirstChildElement("system-out")) {
      EXPECT_EQ(out->NextSiblingElement(), nullptr);
    }
  }
  EXPECT_EQ(suite->IntAttribute("tests"), cases);
  EXPECT_EQ(suite->IntAttribute("failures"), failures);
  EXPECT_EQ(suite->IntAttribute("errors"), errors);
  EXPECT_EQ(cases, static_cast<int>(allRules().size()) + 1);
  EXPECT_EQ(failures, 1);
  EXPECT_EQ(text.find('\x01'), text.npos);
  EXPECT_EQ(text.find('\xFF'), text.npos);
}

TEST(CheckJunit, RulesWithNothingToJudgeAreSkippedWithTheReason) {
  CheckReport report = hostileReport();
  report.unjudged = {{"urdf", "the cell has no file of URDF"}, {"obj", "none"}};
  const std::string text = checkJunit(report);
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(text.c_str()), tinyxml2::XML_SUCCESS);
  std::map<std::string, std::string> skipped;
  const auto* suite = document.FirstChildElement()->FirstChildElement("testsuite");
  for (auto* each = suite->FirstChildElement("testcase"); each != nullptr;
       each = each->NextSiblingElement("testcase")) {
    const auto* why = each->FirstChildElement("skipped");
    if (why != nullptr) skipped[each->Attribute("name")] = why->Attribute("message");
  }
  EXPECT_EQ(skipped["urdf.xml"], "nothing to judge: the cell has no file of URDF");
  EXPECT_FALSE(skipped.contains("obj.bad-face")) << "it has a finding";
  EXPECT_FALSE(skipped.contains("source.gap"));
}

TEST(CheckJunit, ASessionThatNobodyJudgedIsAnError) {
  CheckReport report = hostileReport();
  report.findings.clear();
  report.packets = 0;
  conclude(report);
  EXPECT_THAT(checkJunit(report), HasSubstr("<error message=\"nothing judged"));
  report.packets = 1;
  report.interrupted = true;
  conclude(report);
  EXPECT_EQ(report.verdict, CheckVerdict::interrupted);
  EXPECT_THAT(checkJunit(report), HasSubstr("type=\"interrupted\""));
}

TEST(Baseline, AcceptsUpToTheWorstValue) {
  const auto reportOf = [](double worst) {
    CheckReport report;
    report.has_session = true;
    report.packets = 1;
    report.findings.push_back(findingOf(
        "joint.limit", Severity::error,
        "arm/turn is outside its limits [-90°, 90°]; the worst is " + std::to_string(worst) + "°"));
    report.findings.back().worst = std::abs(worst) - 90;
    conclude(report);
    return report;
  };
  const auto isAccepted = [&](const Baseline& baseline, double worst) {
    CheckReport report = reportOf(worst);
    baseline.applyTo(report);
    return report.findings.front().accepted;
  };
  const std::string text = Baseline::of(reportOf(149)).text();
  EXPECT_THAT(text, HasSubstr("\"worst\":59.0"));
  const Result<Baseline> known = Baseline::parse(bytesOf(text), "known.json");
  ASSERT_TRUE(known.ok()) << known.error().text();
  EXPECT_TRUE(isAccepted(*known, 149));
  EXPECT_TRUE(isAccepted(*known, -120));
  EXPECT_FALSE(isAccepted(*known, 984));
  EXPECT_FALSE(isAccepted(*known, -150));
  // One of an older version accepts any, and says so once.
  const Result<Baseline> old = Baseline::parse(
      bytesOf("{\"format\": 1, \"accepted\": [{\"rule\": \"joint.limit\", \"text\": "
              "\"arm/turn is outside its limits [#, #]; the worst is #\"}]}"),
      "old.json");
  ASSERT_TRUE(old.ok()) << old.error().text();
  EXPECT_TRUE(isAccepted(*old, 984));
  CheckReport report = reportOf(984);
  old->applyTo(report);
  EXPECT_EQ(std::ranges::count(report.findings, "baseline.unvalued", &Finding::rule), 1);
}

TEST(CheckSarif, HasWhatTheSchemaRequiresAndCodeScanningShows) {
  const CheckReport report = hostileReport();
  const Json log = Json::parse(checkSarif(report, "https://example.org/rules"));
  EXPECT_EQ(log.at("version"), "2.1.0");
  ASSERT_EQ(log.at("runs").size(), 1U);
  const Json& run = log["runs"][0];
  const Json& driver = run.at("tool").at("driver");
  EXPECT_EQ(driver.at("name"), "rocinante-check");
  ASSERT_EQ(driver.at("rules").size(), allRules().size());
  for (const Json& rule : driver["rules"]) {
    EXPECT_FALSE(rule.at("shortDescription").at("text").get<std::string>().empty());
    EXPECT_FALSE(rule.at("fullDescription").at("text").get<std::string>().empty());
    const std::string id = rule.at("id").get<std::string>();
    EXPECT_EQ(rule.at("helpUri"), "https://example.org/rules/" + placeOf(id));
    if (id == "joint.limit") {
      EXPECT_EQ(rule["helpUri"], "https://example.org/rules/joint.md#jointlimit");
    }
    EXPECT_TRUE(rule.at("defaultConfiguration").contains("level"));
  }
  ASSERT_EQ(run.at("results").size(), 3U);
  for (const Json& result : run["results"]) {
    const auto index = result.at("ruleIndex").get<std::size_t>();
    EXPECT_EQ(driver["rules"][index]["id"], result.at("ruleId"));
    EXPECT_FALSE(result.at("message").at("text").get<std::string>().empty());
    const Json& place = result.at("locations").at(0).at("physicalLocation");
    EXPECT_GE(place.at("region").at("startLine").get<int>(), 1);
    EXPECT_EQ(place.at("artifactLocation").at("uri").get<std::string>().find(' '),
              std::string::npos);
    EXPECT_TRUE(result.at("partialFingerprints").contains("rocinanteFinding/v1"));
  }
  EXPECT_EQ(run["results"][1]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"],
            "file:///models/a%20b%2Cc%3Ad.obj");
  EXPECT_TRUE(run.at("invocations").at(0).at("executionSuccessful").get<bool>());
}

TEST(CheckSarif, SaysOfEveryRuleWhatItsPageSays) {
  const Json log = Json::parse(checkSarif(hostileReport()));
  for (const Json& rule : log["runs"][0]["tool"]["driver"]["rules"]) {
    EXPECT_FALSE(rule.contains("helpUri")) << "nobody said where the pages lie";
    const RulePage* const page = findRulePage(rule["id"].get<std::string>());
    ASSERT_NE(page, nullptr) << rule["id"];
    EXPECT_FALSE(meaningOf(*page).empty()) << rule["id"];
    EXPECT_EQ(rule["fullDescription"]["text"], std::string(meaningOf(*page)));
    EXPECT_FALSE(mendOf(*page).empty()) << rule["id"];
    EXPECT_EQ(rule["help"]["text"], std::string(mendOf(*page)));
    EXPECT_EQ(rule["help"]["markdown"], explanationOf(*page));
  }
}

TEST(CheckGithub, NothingThatASenderSaysBecomesACommand) {
  const std::string text = checkGithub(hostileReport());
  std::size_t lines = 0;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
    const bool is_ours =
        text.compare(at, 8, "::error ") == 0 || text.compare(at, 10, "::warning ") == 0 ||
        text.compare(at, 9, "::notice ") == 0 || text.compare(at, 6, "cells/") == 0;
    EXPECT_TRUE(is_ours) << text.substr(at, 80);
    ++lines;
  }
  EXPECT_EQ(lines, 4U);
  EXPECT_THAT(text, HasSubstr("]]> %250A::error::x\\x0a::stop\\x01\\xff"));
  EXPECT_THAT(text, HasSubstr("file=/models/a b%2Cc%3Ad.obj,line=7,col=3,title=obj.bad-face::"));
}

TEST(CheckText, KeepsSubjectsTogetherBreaksLinesAndListsOnlySoMany) {
  CheckReport report = hostileReport();
  for (int i = 0; i < 30; ++i) {
    Finding finding = findingOf("joint.limit", Severity::error,
                                "joint " + std::to_string(i) + " is outside its limits");
    finding.subject = i % 2 == 0 ? "left" : "right";
    report.findings.push_back(finding);
  }
  conclude(report);
  TextStyle style;
  style.columns = 40;
  style.most_a_rule = 4;
  const std::string text = checkText(report, style);
  EXPECT_THAT(text, HasSubstr("  left:\n    joint 0 "));
  EXPECT_THAT(text, HasSubstr("and 26 more [joint.limit]"));
  EXPECT_THAT(text, Not(HasSubstr("\033[")));
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    EXPECT_LE(end - at, 44U) << text.substr(at, end - at);  // bytes; \xC3 may count as one more
    at = end + 1;
  }
  EXPECT_EQ(text.find('\x1B'), text.npos) << "a sender could move the cursor";
  EXPECT_THAT(text, testing::StartsWith("incompatible (31 errors, 1 warning, 1\n  note)\n"));
  style.columns = 0;
  EXPECT_THAT(checkText(report, style), testing::StartsWith(report.cell));
  style.color = true;
  EXPECT_THAT(checkText(report, style), HasSubstr("\033[1;31m"));
  style.quiet = true;
  EXPECT_THAT(checkText(report, style), HasSubstr("31 errors, 1 warning, 1 note"));
}

TEST(TimeStrip, ShowsWhereInTheSessionThingsFell) {
  TimeHistogram when;
  when.hit(kReportOrigin + std::chrono::milliseconds(1));
  for (int i = 0; i < 8; ++i) when.hit(kReportOrigin + std::chrono::milliseconds(9990 + i));
  const std::string strip = timeStrip(when, kReportOrigin, std::chrono::seconds(10), 10, false);
  ASSERT_EQ(strip.size(), 10U);
  EXPECT_NE(strip.front(), ' ');
  EXPECT_EQ(strip.back(), '#');
  EXPECT_EQ(strip.substr(2, 6), "      ");
  EXPECT_THAT(timeStrip(when, kReportOrigin, std::chrono::seconds(10), 10, true), HasSubstr("█"));
  EXPECT_EQ(timeStrip(when, kReportOrigin, Nanoseconds(0), 10, false), "");
  EXPECT_EQ(timeStrip(TimeHistogram(), kReportOrigin, std::chrono::seconds(1), 10, false), "");
}

TEST(Baseline, KnowsAFindingAgainWhateverItsNumbers) {
  const auto key = [](const std::string& text) {
    return baselineKeyOf(CheckReport(), findingOf("joint.limit", Severity::error, text)).sentence;
  };
  EXPECT_EQ(key("j is outside [-2, 1.5e-3] rad; the worst is 90"),
            "j is outside [#, #]; the worst is #");
  EXPECT_EQ(key("j is outside [-2°, 1.5e-3°]; the worst is 90°"),
            "j is outside [#, #]; the worst is #")
      << "what was accepted in radians stays accepted in degrees";
  EXPECT_EQ(key("j moves at 5 rad/s for 0.3 s"), key("j moves at 286.479°/s for 0.3 s"));
  EXPECT_EQ(key("has turned by 4 degrees"), key("has turned by 4°"));
  // Numbers in names belong to the name.
  EXPECT_EQ(key("arm/joint_1 and arm2 and x.7 and 3d"), "arm/joint_1 and arm2 and x.7 and 3d");
  EXPECT_EQ(key("bytes 700 to 708 of `12`."), "bytes # to # of `#`.");
}

TEST(Baseline, ARewordedFindingKeepsItsKey) {
  const Finding today = findingOf(
      "source.unrestated", Severity::warning,
      "source me did not send its static state (add, order, colours, drawings) again for 10.1 s; "
      "10 s are expected at most");
  const std::string then = "source me restated nothing for # s; # s are expected at most";
  EXPECT_EQ(baselineKeyOf(CheckReport(), today).sentence, then);
  Finding other = today;
  other.rule = "source.silence";
  EXPECT_NE(baselineKeyOf(CheckReport(), other).sentence, then) << "words of one rule only";

  const std::string file =
      R"({"format": 1, "accepted": [{"rule": "source.unrestated", "text": ")" + then + "\"}]}";
  const Result<Baseline> read = Baseline::parse(bytesOf(file), "known.json");
  ASSERT_TRUE(read.ok()) << read.error().text();
  CheckReport report;
  report.findings = {today};
  read->applyTo(report);
  EXPECT_EQ(report.countOfAccepted(), 1U);
  EXPECT_EQ(report.findings.size(), 1U) << "no entry is stale";
}

TEST(Baseline, WhatItWritesAcceptsTheSameAndNothingElse) {
  CheckReport report = hostileReport();
  const Baseline written = Baseline::of(report);
  EXPECT_EQ(written.size(), 2U);  // a note is not a reason to fail
  const std::string text = written.text();
  const Result<Baseline> read = Baseline::parse(bytesOf(text), "known.json");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->text(), text);
  Finding other = findingOf("packet.unknown-device", Severity::error, "another");
  report.findings.push_back(other);
  read->applyTo(report);
  conclude(report);
  EXPECT_EQ(report.countOfAccepted(), 2U);
  EXPECT_EQ(report.countOf(Severity::error), 1U);
  EXPECT_EQ(report.verdict, CheckVerdict::incompatible);
  EXPECT_EQ(report.findings[0].accepted + report.findings[1].accepted, 1);
}

TEST(Baseline, IsCutAnywhereWithoutHarm) {
  const std::string text = Baseline::of(hostileReport()).text();
  for (std::size_t bytes = 0; bytes + 2 < text.size(); ++bytes) {
    const std::string cut = text.substr(0, bytes);
    EXPECT_FALSE(Baseline::parse(bytesOf(cut), "known.json").ok()) << bytes;
  }
  for (const char* wrong : {"[]", "{}", "{\"format\": 2, \"accepted\": []}", "{\"format\": 1}",
                            "{\"format\": 1, \"accepted\": [7]}", "{\"format\": \"1\"}"}) {
    EXPECT_FALSE(Baseline::parse(bytesOf(std::string_view(wrong)), "known.json").ok()) << wrong;
  }
}

}  // namespace
}  // namespace rocinante
