#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rocinante {

/// One test of a JUnit report. All text may hold anything; it is made safe for XML.
struct JunitCase {
  enum class Outcome : std::uint8_t { passed, skipped, failure, error };

  std::string classname, name;
  std::string file;  ///< of the test; empty: none
  int line = 0;      ///< in `file`
  std::optional<double> seconds;
  std::vector<std::pair<std::string, std::string>> properties;
  Outcome outcome = Outcome::passed;
  std::string message, type, text;  ///< of the outcome; each may be empty
  std::string output;               ///< what else there is to read (system-out)
};

struct JunitSuite {
  std::string collection;  ///< name of the <testsuites> around the suite; empty: none
  std::string name;
  std::vector<JunitCase> cases;
};

/// JUnit XML, as Jenkins and GitLab read it (the schema of Jenkins' xunit plugin).
std::string junitXml(const JunitSuite& suite);

}  // namespace rocinante
