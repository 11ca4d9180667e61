#include "viewer/serve/access_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocinante {
namespace {

AccessRules rulesWith(std::vector<std::string> origins, std::string token = {}) {
  return *AccessRules::of(8080, {"Robot7"}, origins, std::move(token), {});
}

unsigned statusOf(const AccessRules& rules, const AccessRequest& request) {
  const auto refusal = rules.refusal(request);
  return refusal ? refusal->status : 200;
}

TEST(AccessRules, AddressesAndOwnNamesAreOurs) {
  const AccessRules rules = rulesWith({});
  for (const char* host : {"127.0.0.1:8080", "localhost:8080", "LOCALHOST:8080", "[::1]:8080",
                           "192.168.1.7:8080", "robot7:8080"}) {
    EXPECT_EQ(statusOf(rules, {host, "", ""}), 200U) << host;
  }
  for (const char* host :
       {"", "evil.example:8080", "127.0.0.1", "127.0.0.1:80", "localhost:80801",
        "127.0.0.1.evil.example:8080", "localhost.:8080", "[::1:8080", ":8080"}) {
    EXPECT_EQ(statusOf(rules, {host, "", ""}), 421U) << host;
  }
}

TEST(AccessRules, AnOriginIsOursOrNamed) {
  const AccessRules rules = rulesWith({"https://App.Example:8443"});
  const auto status = [&](const char* origin) {
    return statusOf(rules, {"127.0.0.1:8080", origin, ""});
  };
  for (const char* origin :
       {"", "http://127.0.0.1:8080", "https://127.0.0.1:8080", "https://app.example:8443"}) {
    EXPECT_EQ(status(origin), 200U) << origin;
  }
  for (const char* origin :
       {"null", "http://localhost:8080", "http://127.0.0.1", "file://", "http://app.example:8443",
        "https://app.example", "http://evil.example", "http://127.0.0.1:8080.evil.example"}) {
    EXPECT_EQ(status(origin), 403U) << origin;
  }
  EXPECT_EQ(statusOf(rules, {"app.example:8443", "https://app.example:8443", ""}), 200U);
}

TEST(AccessRules, AHeaderThatIsTooLongIsNotTakenForNone) {
  const AccessRules rules = rulesWith({}, "open-sesame");
  EXPECT_EQ(statusOf(rules, {"127.0.0.1:8080", "", "open-sesame", true}), 431U);
  EXPECT_EQ(statusOf(rules, {"127.0.0.1:8080", "", "open-sesame", false}), 200U);
}

TEST(AccessRules, TheTokenIsAskedForLast) {
  const AccessRules rules = rulesWith({}, "open-sesame");
  EXPECT_EQ(statusOf(rules, {"localhost:8080", "", "open-sesame"}), 200U);
  for (const char* token : {"", "open-sesam", "open-sesame ", "OPEN-SESAME"}) {
    EXPECT_EQ(statusOf(rules, {"localhost:8080", "", token}), 401U) << token;
  }
  EXPECT_EQ(statusOf(rules, {"evil.example", "", "open-sesame"}), 421U);
}

TEST(AccessRules, OriginsAreCheckedWhenTheyAreGiven) {
  for (const char* origin : {"", "app.example", "https://", "https://a/b", "https://user@a"}) {
    EXPECT_FALSE(AccessRules::of(80, {}, {origin}, "", {}).ok()) << origin;
  }
}

}  // namespace
}  // namespace rocinante
