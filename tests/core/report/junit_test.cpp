#include "core/report/junit.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(Junit, CountsOutcomesAndNestsThemAsTheSchemaOrders) {
  JunitSuite suite;
  suite.collection = "all";
  suite.name = "one";
  JunitCase& passed = suite.cases.emplace_back();
  passed.classname = "c";
  passed.name = "passed";
  JunitCase& failed = suite.cases.emplace_back(passed);
  failed.name = "failed";
  failed.file = "suite.toml";
  failed.line = 7;
  failed.seconds = 0.25;
  failed.properties = {{"key", "value"}};
  failed.outcome = JunitCase::Outcome::failure;
  failed.message = "why";
  failed.text = "a\nb";
  failed.output = "more";
  JunitCase& skipped = suite.cases.emplace_back(suite.cases[0]);
  skipped.name = "skipped";
  skipped.outcome = JunitCase::Outcome::skipped;
  EXPECT_EQ(junitXml(suite),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites name=\"all\" tests=\"3\" failures=\"1\" errors=\"0\" time=\"0.250\">\n"
            "  <testsuite name=\"one\" tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\" "
            "time=\"0.250\">\n"
            "    <testcase classname=\"c\" name=\"passed\" time=\"0\"/>\n"
            "    <testcase classname=\"c\" name=\"failed\" file=\"suite.toml\" line=\"7\" "
            "time=\"0.250\">\n"
            "      <properties>\n"
            "        <property name=\"key\" value=\"value\"/>\n"
            "      </properties>\n"
            "      <failure message=\"why\">a&#10;b</failure>\n"
            "      <system-out>more</system-out>\n"
            "    </testcase>\n"
            "    <testcase classname=\"c\" name=\"skipped\" time=\"0\">\n"
            "      <skipped/>\n"
            "    </testcase>\n"
            "  </testsuite>\n"
            "</testsuites>\n");
}

TEST(Junit, NoNameBreaksTheDocument) {
  JunitSuite suite;
  suite.name = "<\"&'>\x01\xFF\n";
  EXPECT_EQ(junitXml(suite),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuite name=\"&lt;&quot;&amp;'&gt;\\x01\\xff&#10;\" tests=\"0\" failures=\"0\" "
            "errors=\"0\" skipped=\"0\" time=\"0\"/>\n");
}

}  // namespace
}  // namespace rocinante
