#include "core/report/junit.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

using Outcome = JunitCase::Outcome;

std::string timeText(const std::optional<double>& seconds) {
  return seconds ? fmt::format("{:.3f}", *seconds) : "0";
}

const char* elementOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::skipped:
      return "skipped";
    case Outcome::failure:
      return "failure";
    case Outcome::error:
      return "error";
    case Outcome::passed:
      break;
  }
  return "";
}

/// Indents by two. Text is escaped by xmlText(), since XML cannot hold control characters at all.
class Printer : public tinyxml2::XMLPrinter {
 public:
  Printer() { VisitEnter(tinyxml2::XMLDocument(false)); }

  void attribute(const char* name, const std::string& value) {
    PushAttribute(name, xmlText(value).c_str());
  }
  void attribute(const char* name, std::size_t value) {
    PushAttribute(name, fmt::to_string(value).c_str());
  }
  void optionalAttribute(const char* name, const std::string& value) {
    if (!value.empty()) attribute(name, value);
  }
  void text(const std::string& value) {
    if (!value.empty()) PushText(xmlText(value).c_str());
  }

 private:
  void PrintSpace(int depth) override {
    for (int i = 0; i < depth; ++i) Write("  ");
  }
};

void write(Printer& xml, const JunitCase& test) {
  xml.OpenElement("testcase");
  xml.attribute("classname", test.classname);
  xml.attribute("name", test.name);
  xml.optionalAttribute("file", test.file);
  if (!test.file.empty()) xml.PushAttribute("line", test.line);
  xml.attribute("time", timeText(test.seconds));
  if (!test.properties.empty()) {
    xml.OpenElement("properties");
    for (const auto& [name, value] : test.properties) {
      xml.OpenElement("property");
      xml.attribute("name", name);
      xml.attribute("value", value);
      xml.CloseElement();
    }
    xml.CloseElement();
  }
  if (test.outcome != Outcome::passed) {
    xml.OpenElement(elementOf(test.outcome));
    xml.optionalAttribute("message", test.message);
    xml.optionalAttribute("type", test.type);
    xml.text(test.text);
    xml.CloseElement();
  }
  if (!test.output.empty()) {
    xml.OpenElement("system-out");
    xml.text(test.output);
    xml.CloseElement();
  }
  xml.CloseElement();
}

void writeTotals(Printer& xml, const JunitSuite& suite, const std::string& time,
                 bool with_skipped) {
  const auto count = [&](Outcome outcome) {
    return static_cast<std::size_t>(std::ranges::count(suite.cases, outcome, &JunitCase::outcome));
  };
  xml.attribute("tests", suite.cases.size());
  xml.attribute("failures", count(Outcome::failure));
  xml.attribute("errors", count(Outcome::error));
  if (with_skipped) xml.attribute("skipped", count(Outcome::skipped));
  xml.attribute("time", time);
}

}  // namespace

std::string junitXml(const JunitSuite& suite) {
  std::optional<double> seconds;
  for (const JunitCase& test : suite.cases) {
    if (test.seconds) seconds = seconds.value_or(0) + *test.seconds;
  }
  const std::string time = timeText(seconds);
  Printer xml;
  xml.PushDeclaration("xml version=\"1.0\" encoding=\"UTF-8\"");
  if (!suite.collection.empty()) {
    xml.OpenElement("testsuites");
    xml.attribute("name", suite.collection);
    writeTotals(xml, suite, time, false);
  }
  xml.OpenElement("testsuite");
  xml.attribute("name", suite.name);
  writeTotals(xml, suite, time, true);
  for (const JunitCase& test : suite.cases) write(xml, test);
  xml.CloseElement();
  if (!suite.collection.empty()) xml.CloseElement();
  return xml.CStr();
}

}  // namespace rocinante
