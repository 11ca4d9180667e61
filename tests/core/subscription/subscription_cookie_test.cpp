#include "core/subscription/subscription_cookie.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

SteadyTime at(int seconds) { return SteadyTime(std::chrono::seconds(seconds)); }
SocketAddress addressOf(std::string_view host, std::uint16_t port) {
  return SocketAddress::parse(host, port).value();
}

TEST(CookieMint, ACookieIsValidInItsSlotAndTheTwoThatFollow) {
  const CookieMint mint;
  const SocketAddress home = addressOf("192.0.2.7", 40000);
  const std::string cookie = mint.cookieFor(home, at(3015));
  EXPECT_EQ(cookie.size(), CookieMint::kTextBytes);
  EXPECT_FALSE(mint.accepts(cookie, home, at(2999)));
  EXPECT_TRUE(mint.accepts(cookie, home, at(3000)));
  EXPECT_TRUE(mint.accepts(cookie, home, at(3089)));
  EXPECT_FALSE(mint.accepts(cookie, home, at(3090)));
}

TEST(CookieMint, ACookieIsOfOneAddressAndPort) {
  const CookieMint mint;
  const std::string cookie = mint.cookieFor(addressOf("192.0.2.7", 40000), at(0));
  EXPECT_FALSE(mint.accepts(cookie, addressOf("192.0.2.7", 40001), at(0)));
  EXPECT_FALSE(mint.accepts(cookie, addressOf("192.0.2.8", 40000), at(0)));
  const SocketAddress v6 = addressOf("2001:db8::7", 40000);
  EXPECT_TRUE(mint.accepts(mint.cookieFor(v6, at(0)), v6, at(0)));
  EXPECT_FALSE(mint.accepts(mint.cookieFor(v6, at(0)), addressOf("2001:db8::8", 40000), at(0)));
}

TEST(CookieMint, EachStartHasItsOwnKey) {
  const SocketAddress home = addressOf("192.0.2.7", 40000);
  EXPECT_NE(CookieMint().cookieFor(home, at(0)), CookieMint().cookieFor(home, at(0)));
  const CookieMint::Key key{1, 2, 3};
  EXPECT_EQ(CookieMint(key).cookieFor(home, at(0)), CookieMint(key).cookieFor(home, at(0)));
}

TEST(CookieMint, RefusesWhatIsNotACookie) {
  const CookieMint mint;
  const SocketAddress home = addressOf("192.0.2.7", 40000);
  std::string cookie = mint.cookieFor(home, at(0));
  EXPECT_FALSE(mint.accepts("", home, at(0)));
  EXPECT_FALSE(mint.accepts(cookie + "0", home, at(0)));
  cookie.back() = cookie.back() == '0' ? '1' : '0';
  EXPECT_FALSE(mint.accepts(cookie, home, at(0)));
}

}  // namespace
}  // namespace rocinante
