#include "golden/compare/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "golden/compare/flip_color.h"
#include "tests/golden/compare/test_pictures.h"

namespace rocinante {
namespace {

// The paper's formulas once more, straight from its text: in double, with every two-dimensional
// kernel written out and every pixel computed. Nothing is shared with golden/compare/flip.cpp.
namespace paper {

constexpr double kPi = std::numbers::pi;

struct Vec {
  double x, y, z;
};

double linear(int value) {
  const double c = value / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// sRGB's matrix and white point D65, in the six digits of the standard's derivation.
Vec xyzOf(const Vec& rgb) {
  return {0.4123907992659595 * rgb.x + 0.3575843393838780 * rgb.y + 0.1804807884018343 * rgb.z,
          0.2126390058715104 * rgb.x + 0.7151686787677559 * rgb.y + 0.0721923153607337 * rgb.z,
          0.0193308187155918 * rgb.x + 0.1191947797946259 * rgb.y + 0.9505321522496608 * rgb.z};
}

Vec rgbOf(const Vec& xyz) {
  return {3.2409699419045213 * xyz.x - 1.5373831775700935 * xyz.y - 0.4986107602930033 * xyz.z,
          -0.9692436362808798 * xyz.x + 1.8759675015077206 * xyz.y + 0.0415550574071756 * xyz.z,
          0.0556300796969936 * xyz.x - 0.2039769588889765 * xyz.y + 1.0569715142428784 * xyz.z};
}

const Vec kWhite{0.950455927051672, 1.0, 1.0890577507598784};

Vec opponentOf(const Vec& rgb) {
  const Vec xyz = xyzOf(rgb);
  const double y = xyz.y / kWhite.y;
  return {116 * y - 16, 500 * (xyz.x / kWhite.x - y), 200 * (y - xyz.z / kWhite.z)};
}

Vec clampedRgbOf(const Vec& opponent) {
  const double y = (opponent.x + 16) / 116;
  const Vec rgb =
      rgbOf({kWhite.x * (opponent.y / 500 + y), kWhite.y * y, kWhite.z * (y - opponent.z / 200)});
  const auto unit = [](double value) { return std::min(1.0, std::max(0.0, value)); };
  return {unit(rgb.x), unit(rgb.y), unit(rgb.z)};
}

Vec huntLab(const Vec& rgb) {
  const Vec xyz = xyzOf(rgb);
  const auto f = [](double t) {
    constexpr double kDelta = 6.0 / 29;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  };
  const double x = f(xyz.x / kWhite.x);
  const double y = f(xyz.y / kWhite.y);
  const double z = f(xyz.z / kWhite.z);
  const double lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double hyab(const Vec& a, const Vec& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

double largest() { return std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), 0.7); }

double colorError(double distance) {
  const double raised = std::pow(distance, 0.7);
  const double knee = 0.4 * largest();
  if (raised < knee) return 0.95 / knee * raised;
  return 0.95 + (raised - knee) / (largest() - knee) * 0.05;
}

/// A kernel of (2 r + 1)^2 weights by (dx, dy).
struct Kernel {
  int r;
  std::vector<double> weights;
  double& at(int x, int y) {
    return weights[static_cast<std::size_t>((y + r) * (2 * r + 1) + x + r)];
  }
};

template <class Function>
Kernel kernelOf(int r, Function weight) {
  Kernel kernel{r, std::vector<double>(static_cast<std::size_t>((2 * r + 1) * (2 * r + 1)))};
  for (int y = -r; y <= r; ++y) {
    for (int x = -r; x <= r; ++x) kernel.at(x, y) = weight(x, y);
  }
  return kernel;
}

Kernel sensitivity(double ppd, double a1, double b1, double a2, double b2) {
  const int r = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
  Kernel kernel = kernelOf(r, [&](int x, int y) {
    const double d2 = (x * x + y * y) / (ppd * ppd);
    return a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * d2 / b1) +
           a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * d2 / b2);
  });
  double sum = 0;
  for (const double weight : kernel.weights) sum += weight;
  for (double& weight : kernel.weights) weight /= sum;
  return kernel;
}

Kernel feature(double ppd, bool point, bool vertical) {
  const double sd = 0.5 * 0.082 * ppd;
  Kernel kernel = kernelOf(static_cast<int>(std::ceil(3 * sd)), [&](int x, int y) {
    const double along = vertical ? y : x;
    const double g = std::exp(-(x * x + y * y) / (2 * sd * sd));
    return point ? (along * along / (sd * sd) - 1) * g : -along * g;
  });
  double above = 0;
  double below = 0;
  for (const double weight : kernel.weights) (weight > 0 ? above : below) += std::abs(weight);
  for (double& weight : kernel.weights) weight /= weight > 0 ? above : below;
  return kernel;
}

using Channel = std::vector<double>;

double applied(Kernel& kernel, const Channel& channel, int width, int height, int x, int y) {
  double sum = 0;
  for (int dy = -kernel.r; dy <= kernel.r; ++dy) {
    for (int dx = -kernel.r; dx <= kernel.r; ++dx) {
      const int from_x = std::clamp(x + dx, 0, width - 1);
      const int from_y = std::clamp(y + dy, 0, height - 1);
      sum += kernel.at(dx, dy) * channel[static_cast<std::size_t>(from_y * width + from_x)];
    }
  }
  return sum;
}

std::vector<double> flip(const Picture& a, const Picture& b, double ppd) {
  Kernel achromatic = sensitivity(ppd, 1, 0.0047, 0, 1e-5);
  Kernel red_green = sensitivity(ppd, 1, 0.0053, 0, 1e-5);
  Kernel blue_yellow = sensitivity(ppd, 34.1, 0.04, 13.5, 0.025);
  Kernel edge_x = feature(ppd, false, false);
  Kernel edge_y = feature(ppd, false, true);
  Kernel point_x = feature(ppd, true, false);
  Kernel point_y = feature(ppd, true, true);
  const int width = a.width;
  const int height = a.height;
  Channel channels[2][4];
  for (int which = 0; which < 2; ++which) {
    const Picture& picture = which == 0 ? a : b;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      const Vec opponent = opponentOf(
          {linear(picture.rgba[i]), linear(picture.rgba[i + 1]), linear(picture.rgba[i + 2])});
      channels[which][0].push_back(opponent.x);
      channels[which][1].push_back(opponent.y);
      channels[which][2].push_back(opponent.z);
      channels[which][3].push_back((opponent.x + 16) / 116);
    }
  }
  std::vector<double> map;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Vec colors[2];
      double edges[2];
      double points[2];
      for (int which = 0; which < 2; ++which) {
        const auto& of = channels[which];
        colors[which] = huntLab(clampedRgbOf({applied(achromatic, of[0], width, height, x, y),
                                              applied(red_green, of[1], width, height, x, y),
                                              applied(blue_yellow, of[2], width, height, x, y)}));
        edges[which] = std::hypot(applied(edge_x, of[3], width, height, x, y),
                                  applied(edge_y, of[3], width, height, x, y));
        points[which] = std::hypot(applied(point_x, of[3], width, height, x, y),
                                   applied(point_y, of[3], width, height, x, y));
      }
      const double feature_error =
          std::sqrt(std::max(std::abs(edges[0] - edges[1]), std::abs(points[0] - points[1])) /
                    std::sqrt(2.0));
      map.push_back(std::pow(colorError(hyab(colors[0], colors[1])), 1 - feature_error));
    }
  }
  return map;
}

}  // namespace paper

void expectThePapers(const Picture& a, const Picture& b, double ppd) {
  const Flip found = flipDifference(a, b, ppd);
  const std::vector<double> wanted = paper::flip(a, b, ppd);
  ASSERT_EQ(found.map.size(), wanted.size());
  double sum = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    ASSERT_NEAR(found.map[i], wanted[i], 3e-4) << i;
    sum += wanted[i];
  }
  EXPECT_NEAR(found.mean, sum / static_cast<double>(wanted.size()), 3e-5);
}

TEST(Flip, EqualPicturesHaveNone) {
  const Picture picture = noisePicture(30, 20, 1);
  const Flip found = flipDifference(picture, picture);
  EXPECT_EQ(found.mean, 0);
  EXPECT_EQ(found.max, 0);
}

TEST(Flip, GreenAgainstBlueIsTheLargestDifference) {
  // By definition 1: the paper scales by the distance of these two.
  const Flip found =
      flipDifference(plainPicture(24, 24, 0, 255, 0), plainPicture(24, 24, 0, 0, 255));
  EXPECT_NEAR(found.mean, 1, 1e-5);
  EXPECT_NEAR(found.max, 1, 1e-5);
}

TEST(Flip, PlainColoursGiveTheColourErrorAlone) {
  // Black and white are 100 apart in lightness and have no chroma: 100^0.7 = 25.1189. Green and
  // blue are 203.287 apart, so the scale is 203.287^0.7 = 41.2760 and its knee at 16.5104:
  // 0.95 + 0.05 * (25.1189 - 16.5104) / (41.2760 - 16.5104) = 0.967380.
  EXPECT_NEAR(flip::colorError(100), 0.967380, 1e-5);
  const Flip found =
      flipDifference(plainPicture(20, 20, 0, 0, 0), plainPicture(20, 20, 255, 255, 255));
  EXPECT_NEAR(found.mean, 0.967380, 1e-4);
}

TEST(Flip, ColoursAreThoseOfTheStandards) {
  // CIELAB under D65 of sRGB's green and blue: (87.735, -86.183, 83.180), (32.297, 79.188,
  // -107.860); Hunt's a and b are L / 100 of that.
  const flip::Color green = flip::huntLabOf({0, 1, 0});
  EXPECT_NEAR(green.x, 87.735, 0.01);
  EXPECT_NEAR(green.y, 0.87735 * -86.183, 0.02);
  EXPECT_NEAR(green.z, 0.87735 * 83.180, 0.02);
  const flip::Color blue = flip::huntLabOf({0, 0, 1});
  EXPECT_NEAR(blue.x, 32.297, 0.01);
  EXPECT_NEAR(blue.y, 0.32297 * 79.188, 0.02);
  EXPECT_NEAR(blue.z, 0.32297 * -107.860, 0.02);
  // White has no colour, and comes back from the opponent space.
  const flip::Color white = flip::opponentOf({1, 1, 1});
  EXPECT_NEAR(white.x, 100, 1e-4);
  EXPECT_NEAR(white.y, 0, 1e-4);
  EXPECT_NEAR(white.z, 0, 1e-4);
  const flip::Color back = flip::linearOfOpponent(flip::opponentOf({0.25F, 0.5F, 0.75F}));
  EXPECT_NEAR(back.x, 0.25, 1e-5);
  EXPECT_NEAR(back.y, 0.5, 1e-5);
  EXPECT_NEAR(back.z, 0.75, 1e-5);
}

TEST(Flip, IsThePapersOnNoiseAtSeveralDistances) {
  const Picture a = noisePicture(23, 17, 1);
  const Picture b = noisePicture(23, 17, 2);
  for (const double ppd : {kFlipPixelsPerDegree, 30.0}) {
    SCOPED_TRACE(ppd);
    expectThePapers(a, b, ppd);
  }
}

TEST(Flip, IsThePapersOnEdgesAndPoints) {
  const Picture a = plainPicture(33, 25, 120, 130, 140);
  Picture b = a;
  for (int y = 0; y < 25; ++y) {
    for (int x = 15; x < 33; ++x) pixelAt(b, x, y)[0] = 220;
  }
  pixelAt(b, 5, 5)[1] = 0;
  pixelAt(b, 0, 24)[2] = 255;
  expectThePapers(a, b, kFlipPixelsPerDegree);
}

/// `changed` pixels of a picture of three blocks a row and two rows of blocks, judged there and in
/// a larger picture that holds it at (5, 3): the seams between the blocks lie elsewhere.
void expectNoSeams(const std::vector<std::pair<int, int>>& changed) {
  const Picture a = noisePicture(300, 140, 4);
  Picture b = a;
  for (const auto& [x, y] : changed) pixelAt(b, x, y)[1] ^= 0x80U;
  const Flip found = flipDifference(a, b);
  const auto moved = [](Picture from) {
    Picture to = greyPicture(310, 150, 0);
    for (int y = 0; y < 150; ++y) {
      for (int x = 0; x < 310; ++x) {
        const std::uint8_t* pixel =
            pixelAt(from, std::clamp(x - 5, 0, 299), std::clamp(y - 3, 0, 139));
        std::copy_n(pixel, 4, pixelAt(to, x, y));
      }
    }
    return to;
  };
  const Flip shifted = flipDifference(moved(a), moved(b));
  for (int y = 12; y < 128; ++y) {
    for (int x = 12; x < 288; ++x) {
      ASSERT_NEAR(found.map[static_cast<std::size_t>(y * 300 + x)],
                  shifted.map[static_cast<std::size_t>((y + 3) * 310 + x + 5)], 1e-5)
          << x << " " << y;
    }
  }
}

TEST(Flip, IsTheSameWhereverBlocksMeet) {
  std::vector<std::pair<int, int>> corners;
  for (const int x : {120, 127, 128, 133, 255, 256, 299}) {
    for (const int y : {0, 127, 128, 139}) corners.emplace_back(x, y);
  }
  expectNoSeams(corners);
}

TEST(Flip, ADifferenceIsSeenInTheBlocksBesideItsOwn) {
  for (const auto& [x, y] : {std::pair(127, 60), {128, 60}, {60, 127}, {60, 128}}) {
    expectNoSeams({{x, y}});
  }
}

TEST(Flip, DoesNotTakeSides) {
  const Picture a = noisePicture(40, 30, 5);
  const Picture b = noisePicture(40, 30, 6);
  EXPECT_EQ(flipDifference(a, b).mean, flipDifference(b, a).mean);
}

}  // namespace
}  // namespace rocinante
