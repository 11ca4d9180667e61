#include "viewer/shown/signal_rows.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

Item<SignalValue> said(SignalKind kind, double number, std::string text = {},
                       std::string unit = {}) {
  Item<SignalValue> item;
  item.value = {kind, number, std::move(text), std::move(unit)};
  item.owner = "plc";
  return item;
}

TEST(SignalRows, ReadAsPeopleWriteThem) {
  EXPECT_EQ(signalValueText(said(SignalKind::number, 12.3456789, {}, "N.m").value), "12.346 N.m");
  EXPECT_EQ(signalValueText(said(SignalKind::number, -0.0).value), "0");
  EXPECT_EQ(signalValueText(said(SignalKind::boolean, 1).value), "true");
  EXPECT_EQ(signalValueText(said(SignalKind::boolean, 0).value), "false");
  EXPECT_EQ(signalValueText(said(SignalKind::text, 0, "a\nb\x1b[1m").value).find_first_of("\n\x1b"),
            std::string::npos);
  EXPECT_LE(signalValueText(said(SignalKind::text, 0, std::string(60'000, 'x')).value).size(),
            256U);
}

TEST(SignalRows, ALongTextEndsBehindACharacterAndSaysSo) {
  const auto shown = [](const std::string& text) {
    return signalValueText(said(SignalKind::text, 0, text).value);
  };
  const std::string whole(256, 'x');
  EXPECT_EQ(shown(whole), whole);
  EXPECT_EQ(shown(whole + "x"), std::string(253, 'x') + "...");
  const std::string before(252, 'x');
  EXPECT_EQ(shown(before + "\xc3\xa9 and more"), before + "...");
  EXPECT_EQ(shown(before.substr(1) + "\xc3\xa9 and more"), before.substr(1) + "\xc3\xa9...");
}

TEST(SignalRows, OfADeviceItsLinksAndOfNone) {
  Signals signals;
  signals[{"", "mode"}] = said(SignalKind::text, 0, "auto");
  signals[{"tool 0", "force"}] = said(SignalKind::number, 20, {}, "N");
  const auto rows = signalRows("arm", signals, "", 10);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].series.text(), "signal arm mode");
  EXPECT_EQ(rows[0].text, "auto");
  EXPECT_FALSE(rows[0].isPlotted());
  EXPECT_EQ(rows[1].series.text(), "signal arm/tool%200 force");
  EXPECT_EQ(rows[1].name, "tool 0 force");
  EXPECT_EQ(rows[1].owner, "plc");
  EXPECT_TRUE(rows[1].isPlotted());
  EXPECT_EQ(signalRows("arm", signals, "tool 0", 10).size(), 1U);
  EXPECT_EQ(signalRows("arm", signals, "", 1).size(), 1U) << "at most one row";
  EXPECT_EQ(signalRows("", signals, "", 10)[0].series.text(), "signal - mode");
}

}  // namespace
}  // namespace rocinante
