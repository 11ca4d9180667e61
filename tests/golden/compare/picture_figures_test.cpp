#include "golden/compare/picture_figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "golden/compare/structural_similarity.h"
#include "tests/golden/compare/test_pictures.h"

namespace rocinante {
namespace {

/// The index by its definition: every window on its own, in two passes, weights written out.
double slowSimilarity(const Picture& a, const Picture& b) {
  const auto luminance = [](const Picture& picture, int x, int y) {
    const std::uint8_t* p = picture.rgba.data() + (y * picture.width + x) * 4;
    return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
  };
  double weights[11][11];
  double total = 0;
  for (int y = 0; y < 11; ++y) {
    for (int x = 0; x < 11; ++x) {
      weights[y][x] = std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2 * 1.5 * 1.5));
      total += weights[y][x];
    }
  }
  double sum = 0;
  int windows = 0;
  for (int top = 0; top + 11 <= a.height; ++top) {
    for (int left = 0; left + 11 <= a.width; ++left, ++windows) {
      double ma = 0, mb = 0, va = 0, vb = 0, cov = 0;
      for (int pass = 0; pass < 2; ++pass) {
        for (int y = 0; y < 11; ++y) {
          for (int x = 0; x < 11; ++x) {
            const double weight = weights[y][x] / total;
            const double pa = luminance(a, left + x, top + y);
            const double pb = luminance(b, left + x, top + y);
            if (pass == 0) {
              ma += weight * pa;
              mb += weight * pb;
            } else {
              va += weight * (pa - ma) * (pa - ma);
              vb += weight * (pb - mb) * (pb - mb);
              cov += weight * (pa - ma) * (pb - mb);
            }
          }
        }
      }
      sum += (2 * ma * mb + 6.5025) * (2 * cov + 58.5225) /
             ((ma * ma + mb * mb + 6.5025) * (va + vb + 58.5225));
    }
  }
  return sum / windows;
}

TEST(StructuralSimilarity, IsOneForEqualPicturesAndNoneForSmallOnes) {
  EXPECT_EQ(structuralSimilarity(noisePicture(30, 20, 1), noisePicture(30, 20, 1)), 1.0);
  EXPECT_EQ(structuralSimilarity(noisePicture(10, 20, 1), noisePicture(10, 20, 1)), std::nullopt);
  EXPECT_EQ(structuralSimilarity(noisePicture(20, 10, 1), noisePicture(20, 10, 2)), std::nullopt);
  EXPECT_TRUE(structuralSimilarity(noisePicture(11, 11, 1), noisePicture(11, 11, 2)).has_value());
}

TEST(StructuralSimilarity, OfPlainGreysIsTheirLuminanceTerm) {
  // No variance: (2 * 100 * 150 + C1) / (100^2 + 150^2 + C1).
  const Picture a = plainPicture(20, 20, 100, 100, 100);
  const Picture b = plainPicture(20, 20, 150, 150, 150);
  EXPECT_NEAR(*structuralSimilarity(a, b), (2 * 100 * 150 + 6.5025) / (32500 + 6.5025), 1e-9);
}

TEST(StructuralSimilarity, IsTheDefinitionWindowByWindow) {
  const Picture a = noisePicture(29, 23, 1);
  Picture b = a;
  for (int y = 4; y < 12; ++y) {
    for (int x = 3; x < 17; ++x) pixelAt(b, x, y)[1] ^= 0x41U;
  }
  EXPECT_NEAR(*structuralSimilarity(a, b), slowSimilarity(a, b), 1e-9);
  EXPECT_NEAR(*structuralSimilarity(a, noisePicture(29, 23, 2)),
              slowSimilarity(a, noisePicture(29, 23, 2)), 1e-9);
}

TEST(StructuralSimilarity, OfALargePictureSkipsOnlyWhatIsEqual) {
  const Picture a = noisePicture(290, 150, 1);
  Picture b = a;
  for (const int x : {0, 137, 138, 289}) {
    for (const int y : {0, 127, 128, 149}) pixelAt(b, x, y)[0] ^= 0xFFU;
  }
  EXPECT_NEAR(*structuralSimilarity(a, b), slowSimilarity(a, b), 1e-10);
}

TEST(PictureFigures, RootMeanSquareAndPeakSignalToNoise) {
  const Picture a = plainPicture(16, 16, 100, 100, 100);
  const Picture b = plainPicture(16, 16, 103, 104, 100);
  const PictureFigures opaque = pictureFigures(a, b);
  EXPECT_NEAR(opaque.rmse, std::sqrt((9 + 16 + 0) / 3.0), 1e-12);
  EXPECT_NEAR(*opaque.psnr, 20 * std::log10(255 / std::sqrt(25 / 3.0)), 1e-9);
  // Alpha counts as soon as one pixel of either is not opaque.
  Picture c = b;
  pixelAt(c, 0, 0)[3] = 251;
  EXPECT_NEAR(pictureFigures(a, c).rmse, std::sqrt((25.0 * 256 + 16) / (256 * 4)), 1e-12);
}

TEST(PictureFigures, EqualPicturesAreInfinitelyClose) {
  const Picture picture = noisePicture(16, 16, 3);
  const PictureFigures figures = pictureFigures(picture, picture);
  EXPECT_EQ(figures.rmse, 0);
  EXPECT_EQ(figures.psnr, std::nullopt);
  EXPECT_EQ(figures.ssim, 1.0);
}

}  // namespace
}  // namespace rocinante
