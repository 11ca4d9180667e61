// Whatever is set: after a flush receivers have it, and after a whole restatement also those that
// joined late or lost datagrams.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>
#include <random>

#include "core/packet/text_number.h"
#include "tests/core/source/source_driver.h"

#define RK_SOURCE_STATIC
#define RK_SOURCE_IMPLEMENTATION
#include "core/source/rocinante/rocinante_source.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::ExpectedState;
using test::itemsOf;

/// A receiver: decodes and folds; keeps which parts of the last restatement it has heard.
struct Receiver {
  PacketTextDecoder decoder;
  SessionState state;
  std::uint32_t parts_heard = 0;
  bool has_all = false;

  void hear(Nanoseconds now, std::string_view datagram) {
    const Packet* const packet = decoder.decode(bytesOf(datagram));
    RC_ASSERT(packet != nullptr);
    RC_ASSERT(packet->faults.empty());
    state.apply(LogTime(now), *packet);
    if (!packet->header.part) return;
    parts_heard = packet->header.part->index == 1 ? 1 : parts_heard + 1;
    if (parts_heard == packet->header.part->count) has_all = true;
  }
};

/// `script` sent with `step` between flushes; `lossy` hears some, and from `all_from` on
/// everything, like `late`, which hears nothing before. Compared when both have heard a whole
/// restatement.
void sendToThree(std::uint64_t seed, int updates, Nanoseconds step, std::size_t max_datagram) {
  std::vector<std::string> datagrams;
  SourceSettings settings;
  settings.source = "s";
  settings.run = "r";
  settings.max_datagram = max_datagram;
  auto source = Source::open(settings, [&](std::span<std::byte> datagram) {
                  datagrams.emplace_back(textOf(datagram));
                  return true;
                }).value();
  test::UpdateScript script(seed);
  std::mt19937_64 losses(seed);
  ExpectedState expected;
  Receiver prompt;
  Receiver lossy;
  Receiver late;
  const Nanoseconds all_from = step * (updates / 2);
  bool compared = false;
  for (int i = 0; !compared; ++i) {
    const Nanoseconds now = step * i;
    // Always as many items: the time until a restatement is whole must not depend on chance.
    for (std::uint32_t each = script.below(8); each > 0; --each) {
      const auto words = test::wordsOf(script.next());
      if (test::follow(source, words) == SourceResult::done) expected.apply(words);
    }
    RC_ASSERT(source.flush(WallTime(now)) == SourceResult::done);
    for (const std::string& datagram : datagrams) {
      RC_ASSERT(datagram.size() <= max_datagram);
      prompt.hear(now, datagram);
      if (now >= all_from || losses() % 3 != 0) lossy.hear(now, datagram);
      if (now >= all_from) late.hear(now, datagram);
    }
    datagrams.clear();
    RC_ASSERT(itemsOf(prompt.state) == itemsOf(expected.state()));
    compared = late.has_all && now > all_from + 3s;
  }
  RC_ASSERT(itemsOf(late.state) == itemsOf(expected.state()));
  RC_ASSERT(itemsOf(lossy.state) == itemsOf(expected.state()));
  const auto& counts = prompt.state.counts().at("s");
  RC_ASSERT(counts.gap == 0U);
  RC_ASSERT(counts.late == 0U);
  RC_ASSERT(prompt.state.sources().at("s").highest_sequence == source.sent() - 1);
}

RC_GTEST_PROP(SourceProperty, ReceiversEndUpWithWhatWasSet, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const int updates = *rc::gen::inRange(1, 60);
  const Nanoseconds step = *rc::gen::element<Nanoseconds>(10ms, 40ms, 99ms);
  sendToThree(seed, updates, step, *rc::gen::element<std::size_t>(300, 1200, 9000));
}

std::string standardText(double number) {
  std::array<char, 64> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, 9);
  std::string digits(text.data(), end.ptr);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.ends_with('.')) digits.pop_back();
  return digits == "-0" ? "0" : digits;
}

std::string ownText(double number) {
  std::array<char, 32> text{};
  return {text.data(), rk_number_text(text.data(), number)};
}

RC_GTEST_PROP(SourceNumber, IsTheStandardLibrarysNineDecimals, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  for (int i = 0; i < 300; ++i) {
    // Bits of every exponent, numbers as machines have them, and the ties: odd multiples of 2^-10.
    const std::uint64_t bits = random();
    const auto integer = static_cast<std::int32_t>(random());
    const double near = std::bit_cast<double>((bits % (std::uint64_t{1076 - 990} << 52U)) +
                                              (std::uint64_t{990} << 52U));
    for (const double number :
         {std::bit_cast<double>(bits), near, -near, integer / 1e8, integer / 1024.0, integer / 1e12,
          static_cast<double>(bits % (1ULL << 53U)) / 16, (integer + 0.5) / 1e9}) {
      if (number > -0x1p53 && number < 0x1p53) {
        RC_ASSERT(ownText(number) == standardText(number));
      } else {
        RC_ASSERT(ownText(number).empty());
      }
    }
  }
}

std::string significantOf(std::string_view text) {
  std::string digits;
  for (const char each : text.substr(0, text.find('e'))) {
    if (each >= '0' && each <= '9' && (each != '0' || !digits.empty())) digits += each;
  }
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits;
}

RC_GTEST_PROP(SourceSignal, SaysTheFewestDigitsThatReadBack, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::string said;
  const auto keep = [&](std::span<std::byte> datagram) {
    said = textOf(datagram);
    return true;
  };
  SourceSettings settings;
  settings.source = "s";
  settings.restate = 0s;
  Result<Source> source = Source::open(settings, keep);
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t bits = random();
    const auto integer = static_cast<std::int32_t>(random());
    for (const double number :
         {std::bit_cast<double>(bits), integer / 1e8, integer * 1e-17, integer / 1e-9,
          static_cast<double>(bits), static_cast<double>(bits % (1ULL << 53U)) / 16,
          std::ldexp(1.0, static_cast<int>(bits % 2098) - 1074)}) {
      said.clear();
      const SourceResult result = source->setSignal({}, "x", number);
      if (!std::isfinite(number)) {
        RC_ASSERT(result == SourceResult::bad_number);
        continue;
      }
      RC_ASSERT(source->flush(WallTime(Nanoseconds(1))) == SourceResult::done);
      if (said.empty()) continue;  // the number of before
      const std::string text = said.substr(said.find_last_of("= ") + 1);
      RC_ASSERT(text.size() <= 25U);
      const char* at = text.data();
      double read = 0;
      RC_ASSERT(readNumber(at, text.data() + text.size() - 1, read));
      RC_ASSERT(at == text.data() + text.size() - 1);
      RC_ASSERT(read == number);
      std::array<char, 64> shortest{};
      const auto end = std::to_chars(shortest.data(), shortest.data() + shortest.size(), number,
                                     std::chars_format::scientific);
      RC_ASSERT(significantOf(text) == significantOf({shortest.data(), end.ptr}));
    }
  }
}

TEST(SourceSignal, AnExponentIsForWhatNineDecimalsCannotSay) {
  const auto text = [](double number) {
    std::array<char, 32> bytes{};
    return std::string(bytes.data(), rk_put_exact(bytes.data(), number));
  };
  EXPECT_EQ(text(1e-12), "1e-12");
  EXPECT_EQ(text(-1.5e-7), "-1.5e-7");
  EXPECT_EQ(text(1e-5), "0.00001");
  EXPECT_EQ(text(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(text(100000), "100000");
  EXPECT_EQ(text(1700000000.25), "1700000000.25");
  EXPECT_EQ(text(0x1p53), "9.007199254740992e15");
  EXPECT_EQ(text(-0.0), "0");
}

TEST(SourceMemoryMacro, IsEnoughForArmsWithOrdersAndPoses) {
  const auto ignore = [](void*, char*, std::size_t) { return 0; };
  for (const std::size_t devices : {1U, 7U, 100U, 3000U}) {
    for (const std::size_t joints : {1U, 6U, 14U}) {
      std::vector<char> memory(RK_SOURCE_BYTES(devices, devices * joints));
      rk_source_config config{};
      config.source = "source_with_15b";
      config.send = ignore;
      rk_source* const source = rk_source_open(memory.data(), memory.size(), &config, nullptr);
      ASSERT_NE(source, nullptr);
      std::vector<std::string> names;
      std::vector<const char*> pointers;
      for (std::size_t i = 0; i < joints; ++i)
        names.push_back("a_15_byte_joint" + std::string(1, static_cast<char>('a' + i)));
      for (std::string& name : names) pointers.push_back(name.erase(0, 1).c_str());
      const std::vector<double> values(joints, 0.5);
      const double pose[] = {1, 2, 3, 0, 0, 0, 1};
      for (std::size_t i = 0; i < devices; ++i) {
        const rk_device device =
            rk_source_device(source, ("dev_15_byte" + std::to_string(1000 + i)).c_str());
        ASSERT_EQ(rk_source_add(source, device, "model_of_15byte", nullptr), RK_OK);
        ASSERT_EQ(rk_source_order(source, device, pointers.data(), joints), RK_OK);
        ASSERT_EQ(rk_source_joints(source, device, values.data(), joints), RK_OK);
        ASSERT_EQ(
            rk_source_pose(source, device, pose, rk_link("device_15_bytes", "link_of_15bytes")),
            RK_OK);
      }
      EXPECT_EQ(rk_source_flush(source, 0), RK_OK);
    }
  }
}

}  // namespace
}  // namespace rocinante
