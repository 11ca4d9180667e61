#include "core/math/trigonometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace rocinante {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The distance in units of the last place of `want`.
double unitsApart(double got, long double want) {
  const double rounded = std::fabs(static_cast<double>(want));
  const double unit = std::nextafter(rounded, kInfinity) - rounded;
  return static_cast<double>(std::fabs((static_cast<long double>(got) - want) / unit));
}

struct SineCosineRow {
  double angle, sine, cosine;
};

// Correctly rounded, computed with 1,400 bits.
constexpr SineCosineRow kSineCosine[] = {
    {0x1p-1074, 0x0.0000000000001p-1022, 0x1.0000000000000p+0},
    {0x1p-30, 0x1.0000000000000p-30, 0x1.0000000000000p+0},
    {0x1.921fb54442d18p-2, 0x1.87de2a6aea963p-2, 0x1.d906bcf328d46p-1},
    {0x1.921fb54442d18p-1, 0x1.6a09e667f3bccp-1, 0x1.6a09e667f3bcdp-1},
    {0x1.921fb54442d19p-1, 0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bccp-1},
    {0x1p+0, 0x1.aed548f090ceep-1, 0x1.14a280fb5068cp-1},
    {0x1.921fb54442d18p+0, 0x1.0000000000000p+0, 0x1.1a62633145c07p-54},
    {0x1.921fb54442d19p+0, 0x1.0000000000000p+0, -0x1.72cece675d1fdp-53},
    {0x1.2d97c7f3321d2p+1, 0x1.6a09e667f3bcdp-1, -0x1.6a09e667f3bccp-1},
    {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53, -0x1.0000000000000p+0},
    {0x1.921fb54442d18p+2, -0x1.1a62633145c07p-52, 0x1.0000000000000p+0},
    {0x1.6p+6, 0x1.21fb9f12663c8p-5, 0x1.ffaddae3eef21p-1},
    {0x1.8p+9, 0x1.fc5abeca45098p-1, 0x1.e7eaa9aac9385p-4},
    {0x1p+20, 0x1.526ccb2fc8656p-2, 0x1.e33ada92fe2aep-1},
    {0x1.921fb54442d18p+30, -0x1.1a62633145c03p-24, 0x1.fffffffffffedp-1},
    {0x1.8p+60, -0x1.9a7f0a041a3a3p-4, 0x1.fd6c1b946c814p-1},
    {0x1.52d02c7e14af6p+76, -0x1.4bd4cba14452ep-2, 0x1.e45f2c19a7c81p-1},
    {0x1.6ac5b262ca1ffp+849, 0x1.0000000000000p+0, -0x1.14ae72e6ba22fp-61},
    {0x1.fffffffffffffp+1023, 0x1.452fc98b34e97p-8, -0x1.fffe62ecfab75p-1},
    {0x1.52e6b43e54e9cp+151, 0x1.386f1b5067df8p-1, 0x1.959f29cba6fdcp-1},
    {0x1.65132714d4748p+46, -0x1.300c96272fbfcp-1, -0x1.9bf1bd819b43ap-1},
    {0x1.128b2f3a47e10p+545, -0x1.5701686961af5p-3, -0x1.f8c499902f060p-1},
    {0x1.1818e80bb3b94p+593, -0x1.5967cdade3c82p-1, -0x1.79f0c75375e14p-1},
    {0x1.0ed9047d1c4bbp+516, -0x1.34f8a763891b4p-1, -0x1.9843f8fd53249p-1},
    {0x1.36f675c1332a2p+85, 0x1.ff8b1fefb6687p-1, -0x1.59df07cc65388p-5},
    {0x1.6f03674d61aa9p+68, 0x1.d537727deb1bcp-1, 0x1.99c78754e3a83p-2},
    {0x1.3d9c1722e71f0p+561, 0x1.901a0215c0adfp-5, -0x1.ff6393c8b19cdp-1},
    {0x1.6cad4a21e43bbp+843, -0x1.94ef8e5877aadp-2, -0x1.d64445907257bp-1},
};

TEST(Trigonometry, SineAndCosineAreWithinOneUnitForAnglesOfAllSizes) {
  for (const SineCosineRow& row : kSineCosine) {
    SCOPED_TRACE(row.angle);
    EXPECT_LE(unitsApart(sine(row.angle), row.sine), 1.0);
    EXPECT_LE(unitsApart(cosine(row.angle), row.cosine), 1.0);
    EXPECT_EQ(sine(-row.angle), -sine(row.angle));
    EXPECT_EQ(cosine(-row.angle), cosine(row.angle));
  }
}

struct ArcRow {
  double value, arc_sine, arc_cosine;
};

constexpr ArcRow kArcs[] = {
    {0x0.0p+0, 0x0.0p+0, 0x1.921fb54442d18p+0},
    {0x1.0000000000000p-40, 0x1.0000000000000p-40, 0x1.921fb54441d18p+0},
    {0x1.999999999999ap-4, 0x1.9a49276037884p-4, 0x1.787b22ce3f590p+0},
    {0x1.0000000000000p-2, 0x1.02be9ce0b87cdp-2, 0x1.51700e0c14b25p+0},
    {0x1.0000000000000p-1, 0x1.0c152382d7366p-1, 0x1.0c152382d7366p+0},
    {0x1.6a09e667f3bcdp-1, 0x1.921fb54442d19p-1, 0x1.921fb54442d18p-1},
    {0x1.ccccccccccccdp-1, 0x1.1ea93705fa172p+0, 0x1.cdd9f8f922e98p-2},
    {0x1.ffffe00000000p-1, 0x1.91c532ca3026ap+0, 0x1.6a09e84aaba17p-10},
    {0x1.fffffffffffffp-1, 0x1.921fb50442d18p+0, 0x1.0000000000000p-26},
    {0x1.0000000000000p+0, 0x1.921fb54442d18p+0, 0x0.0p+0},
    {-0x1.3333333333333p-2, -0x1.380159e14f6ffp-2, 0x1.e0200bbc96ad8p+0},
    {-0x1.ff7ced916872bp-1, -0x1.86ac9ad18f803p+0, 0x1.8c66280ae928ep+1},
    {-0x1.0000000000000p+0, -0x1.921fb54442d18p+0, 0x1.921fb54442d18p+1},
};

TEST(Trigonometry, ArcSineAndArcCosineAreWithinOneUnit) {
  for (const ArcRow& row : kArcs) {
    SCOPED_TRACE(row.value);
    EXPECT_LE(unitsApart(arcSine(row.value), row.arc_sine), 1.0);
    EXPECT_LE(unitsApart(arcCosine(row.value), row.arc_cosine), 1.0);
  }
  EXPECT_EQ(arcCosine(1.0), 0.0);
  EXPECT_EQ(arcCosine(-1.0), kPi);
  EXPECT_EQ(arcSine(1.0), kPi / 2);
  EXPECT_TRUE(std::isnan(arcSine(1.0000000000000002)));
  EXPECT_TRUE(std::isnan(arcCosine(-2.0)));
  EXPECT_TRUE(std::isnan(arcCosine(std::nan(""))));
}

struct AngleRow {
  double y, x, angle;
};

constexpr AngleRow kAngles[] = {
    {0x1.0000000000000p+0, 0x1.0000000000000p+0, 0x1.921fb54442d18p-1},
    {0x1.0000000000000p+0, 0x1.0000000000000p+1, 0x1.dac670561bb4fp-2},
    {0x1.0000000000000p+1, 0x1.0000000000000p+0, 0x1.1b6e192ebbe44p+0},
    {0x1.56e1fc2f8f359p-997, 0x1.0000000000000p+0, 0x1.56e1fc2f8f359p-997},
    {0x1.0000000000000p+0, 0x1.56e1fc2f8f359p-997, 0x1.921fb54442d18p+0},
    {0x0.0000000000001p-1022, 0x0.0000000000001p-1022, 0x1.921fb54442d18p-1},
    {0x0.0000000000001p-1022, 0x0.012688b70e62bp-1022, 0x1.bd03c81406992p-45},
    {0x1.e42d130773b76p+1023, 0x1.e42d130773b76p+1023, 0x1.921fb54442d18p-1},
    {0x1.e42d130773b76p+1023, 0x1.7e43c8800759cp+996, 0x1.921fb52aff1a6p+0},
    {0x1.4f8b588e368f1p-17, -0x1.0000000000000p+0, 0x1.921f61616cae0p+1},
    {0x1.8000000000000p+1, -0x1.0000000000000p+2, 0x1.3fc176b7a8560p+1},
    {-0x1.8000000000000p+1, -0x1.0000000000000p+2, -0x1.3fc176b7a8560p+1},
    {-0x1.8000000000000p+1, 0x1.0000000000000p+2, -0x1.4978fa3269ee1p-1},
    {0x1.0000000000000p-1, 0x1.00000000dbe70p-1, 0x1.921fb54366ea8p-1},
    {0x1.87e92154ef7acp-665, -0x1.50a6110d6a9b8p-698, 0x1.921fb544b0c50p+0},
    {-0x1.0000000000000p-70, 0x1.0000000000000p+0, -0x1.0000000000000p-70},
    {0x1.0000000000000p-64, 0x1.0000000000000p+0, 0x1.0000000000000p-64},
    {0x1.0000000000000p+0, 0x1.0000000000000p-65, 0x1.921fb54442d18p+0},
};

TEST(Trigonometry, ArcTangentOfTwoIsWithinOneUnit) {
  for (const AngleRow& row : kAngles) {
    SCOPED_TRACE(testing::Message() << row.y << " / " << row.x);
    EXPECT_LE(unitsApart(arcTangent2(row.y, row.x), row.angle), 1.0);
  }
}

TEST(Trigonometry, ArcTangentOfTwoKeepsSignsOfZerosAndInfinities) {
  EXPECT_FALSE(std::signbit(arcTangent2(0.0, 1.0)));
  EXPECT_TRUE(std::signbit(arcTangent2(-0.0, 1.0)));
  EXPECT_EQ(arcTangent2(0.0, -0.0), kPi);
  EXPECT_EQ(arcTangent2(-0.0, -1.0), -kPi);
  EXPECT_EQ(arcTangent2(1.0, 0.0), kPi / 2);
  EXPECT_EQ(arcTangent2(-1.0, -0.0), -kPi / 2);
  EXPECT_EQ(arcTangent2(kInfinity, kInfinity), kPi / 4);
  EXPECT_EQ(arcTangent2(kInfinity, -kInfinity), 0x1.2d97c7f3321d2p+1);
  EXPECT_EQ(arcTangent2(1.0, -kInfinity), kPi);
  EXPECT_EQ(arcTangent2(-kInfinity, 1.0), -kPi / 2);
  EXPECT_TRUE(std::isnan(arcTangent2(std::nan(""), 1.0)));
}

TEST(Trigonometry, ZerosKeepTheirSignAndInfiniteAnglesHaveNoSine) {
  EXPECT_TRUE(std::signbit(sine(-0.0)));
  EXPECT_FALSE(std::signbit(sine(0.0)));
  EXPECT_EQ(cosine(-0.0), 1.0);
  EXPECT_TRUE(std::isnan(sine(kInfinity)));
  EXPECT_TRUE(std::isnan(cosine(-kInfinity)));
  EXPECT_TRUE(std::isnan(tangent(std::nan(""))));
}

TEST(Trigonometry, AgreesWithLongDoublesOverManyRandomArguments) {
  // The C library's long doubles have 64 digits: they judge to a thousandth of a unit.
  std::mt19937_64 random(1996);
  std::uniform_real_distribution<double> angles(-20.0, 20.0), values(-1.0, 1.0);
  double worst = 0.0, worst_tangent = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const double angle = angles(random), value = values(random), other = values(random);
    worst = std::max(worst, unitsApart(sine(angle), std::sin(static_cast<long double>(angle))));
    worst = std::max(worst, unitsApart(cosine(angle), std::cos(static_cast<long double>(angle))));
    worst = std::max(worst, unitsApart(arcSine(value), std::asin(static_cast<long double>(value))));
    worst =
        std::max(worst, unitsApart(arcCosine(value), std::acos(static_cast<long double>(value))));
    worst = std::max(worst, unitsApart(arcTangent2(value, other),
                                       std::atan2(static_cast<long double>(value), other)));
    worst_tangent = std::max(worst_tangent,
                             unitsApart(tangent(angle), std::tan(static_cast<long double>(angle))));
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_LE(worst_tangent, 3.0);
}

// FNV-1a over the bits of results: short enough to write here, so that the test depends on nothing
// else.
class ResultHash {
 public:
  void add(double result) {
    const auto bits = std::bit_cast<std::uint64_t>(result);
    for (int shift = 0; shift < 64; shift += 8) {
      hash_ = (hash_ ^ (bits >> shift & 0xFF)) * 0x100000001b3;
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

TEST(Trigonometry, GivesTheSameBitsOnEveryMachine) {
  ResultHash hash;
  for (int i = -40000; i <= 40000; ++i) {
    const double angle = i * 0x1p-9 + i * 0x1p-40;
    const double value = i / 40000.0;
    hash.add(sine(angle));
    hash.add(cosine(angle));
    hash.add(tangent(angle));
    hash.add(sine(angle * 0x1p200));
    hash.add(arcSine(value));
    hash.add(arcCosine(value));
    hash.add(arcTangent(angle));
    hash.add(arcTangent2(value, 0.25 - value * value));
  }
  // A machine, compiler or optimisation that changes this number changes pictures.
  EXPECT_EQ(hash.value(), 0x4ed02208f9b1fa73ULL);
}

}  // namespace
}  // namespace rocinante
