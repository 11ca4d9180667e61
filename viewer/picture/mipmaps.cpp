#include "viewer/picture/mipmaps.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace rocinante {
namespace {

// Linear light of a display value (IEC 61966-2-1) in units of 1/65535. A table, because pow()
// differs between C libraries.
constexpr std::array<std::uint16_t, 256> kLinear{
    0,     20,    40,    60,    80,    99,    119,   139,   159,   179,   199,   219,   241,
    264,   288,   313,   340,   367,   396,   427,   458,   491,   526,   562,   599,   637,
    677,   718,   761,   805,   851,   898,   947,   997,   1048,  1101,  1156,  1212,  1270,
    1330,  1391,  1453,  1517,  1583,  1651,  1720,  1790,  1863,  1937,  2013,  2090,  2170,
    2250,  2333,  2418,  2504,  2592,  2681,  2773,  2866,  2961,  3058,  3157,  3258,  3360,
    3464,  3570,  3678,  3788,  3900,  4014,  4129,  4247,  4366,  4488,  4611,  4736,  4864,
    4993,  5124,  5257,  5392,  5530,  5669,  5810,  5953,  6099,  6246,  6395,  6547,  6700,
    6856,  7014,  7174,  7335,  7500,  7666,  7834,  8004,  8177,  8352,  8528,  8708,  8889,
    9072,  9258,  9445,  9635,  9828,  10022, 10219, 10417, 10619, 10822, 11028, 11235, 11446,
    11658, 11873, 12090, 12309, 12530, 12754, 12980, 13209, 13440, 13673, 13909, 14146, 14387,
    14629, 14874, 15122, 15371, 15623, 15878, 16135, 16394, 16656, 16920, 17187, 17456, 17727,
    18001, 18277, 18556, 18837, 19121, 19407, 19696, 19987, 20281, 20577, 20876, 21177, 21481,
    21787, 22096, 22407, 22721, 23038, 23357, 23678, 24002, 24329, 24658, 24990, 25325, 25662,
    26001, 26344, 26688, 27036, 27386, 27739, 28094, 28452, 28813, 29176, 29542, 29911, 30282,
    30656, 31033, 31412, 31794, 32179, 32567, 32957, 33350, 33745, 34143, 34544, 34948, 35355,
    35764, 36176, 36591, 37008, 37429, 37852, 38278, 38706, 39138, 39572, 40009, 40449, 40891,
    41337, 41785, 42236, 42690, 43147, 43606, 44069, 44534, 45002, 45473, 45947, 46423, 46903,
    47385, 47871, 48359, 48850, 49344, 49841, 50341, 50844, 51349, 51858, 52369, 52884, 53401,
    53921, 54445, 54971, 55500, 56032, 56567, 57105, 57646, 58190, 58737, 59287, 59840, 60396,
    60955, 61517, 62082, 62650, 63221, 63795, 64372, 64952, 65535,
};

/// The nearest display value by linear light; the higher one of two.
const std::vector<std::uint8_t>& displayValues() {
  static const std::vector<std::uint8_t> kDisplay = [] {
    std::vector<std::uint8_t> values(65536);
    std::size_t linear = 0;
    for (std::size_t value = 0; value < 255; ++value) {
      const std::size_t middle = (std::size_t{kLinear[value]} + kLinear[value + 1] - 1) / 2;
      for (; linear <= middle; ++linear) values[linear] = static_cast<std::uint8_t>(value);
    }
    for (; linear < values.size(); ++linear) values[linear] = 255;
    return values;
  }();
  return kDisplay;
}

/// Source pixels and weights of one target pixel along an axis. An odd length gives three, so that
/// no pixel is lost and nothing shifts.
struct Taps {
  int first = 0;
  int count = 1;
  std::array<std::uint32_t, 3> weight{1, 0, 0};
};

std::vector<Taps> tapsOf(int source_length) {
  if (source_length == 1) return {Taps{}};
  const int length = source_length / 2;
  std::vector<Taps> taps(static_cast<std::size_t>(length));
  for (int i = 0; i < length; ++i) {
    Taps& tap = taps[static_cast<std::size_t>(i)];
    tap.first = 2 * i;
    if (source_length % 2 == 0) {
      tap.count = 2;
      tap.weight = {1, 1, 0};
    } else {
      tap.count = 3;
      tap.weight = {static_cast<std::uint32_t>(length - i), static_cast<std::uint32_t>(length),
                    static_cast<std::uint32_t>(i + 1)};
    }
  }
  return taps;
}

/// Averages 2x2 opaque pixels, equal to the general rule.
void halveOpaque(const std::uint8_t* above, const std::uint8_t* below,
                 const std::vector<std::uint8_t>& display, std::uint8_t* out) {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::uint32_t light = std::uint32_t{kLinear[above[c]]} + kLinear[above[4 + c]] +
                                kLinear[below[c]] + kLinear[below[4 + c]];
    out[c] = display[(light + 2) / 4];
  }
  out[3] = 255;
}

}  // namespace

Picture halved(const Picture& picture) {
  const std::vector<Taps> columns = tapsOf(picture.width);
  const std::vector<Taps> rows = tapsOf(picture.height);
  Picture half;
  half.width = static_cast<int>(columns.size());
  half.height = static_cast<int>(rows.size());
  half.rgba.resize(columns.size() * rows.size() * 4);

  const std::vector<std::uint8_t>& display = displayValues();
  const std::size_t row_bytes = static_cast<std::size_t>(picture.width) * 4;
  std::uint8_t* out = half.rgba.data();
  for (const Taps& row : rows) {
    const std::uint8_t* const above =
        picture.rgba.data() + static_cast<std::size_t>(row.first) * row_bytes;
    for (const Taps& column : columns) {
      if (row.count == 2 && column.count == 2) {
        const std::uint8_t* const a = above + static_cast<std::size_t>(column.first) * 4;
        const std::uint8_t* const b = a + row_bytes;
        if ((a[3] & a[7] & b[3] & b[7]) == 255) {
          halveOpaque(a, b, display, out);
          out += 4;
          continue;
        }
      }
      // Light times opacity times area, opacity times area, area. With sides up to 2^15 the
      // weights reach 2^28 and the sums 2^54.
      std::array<std::uint64_t, 3> light{};
      std::array<std::uint64_t, 3> plain_light{};
      std::uint64_t opacity = 0;
      std::uint64_t area = 0;
      for (int y = 0; y < row.count; ++y) {
        for (int x = 0; x < column.count; ++x) {
          const std::size_t at =
              (static_cast<std::size_t>(row.first + y) * static_cast<std::size_t>(picture.width) +
               static_cast<std::size_t>(column.first + x)) *
              4;
          const std::uint8_t* pixel = &picture.rgba[at];
          const std::uint64_t weight = std::uint64_t{row.weight[static_cast<std::size_t>(y)]} *
                                       column.weight[static_cast<std::size_t>(x)];
          for (std::size_t c = 0; c < 3; ++c) {
            light[c] += weight * pixel[3] * kLinear[pixel[c]];
            plain_light[c] += weight * kLinear[pixel[c]];
          }
          opacity += weight * pixel[3];
          area += weight;
        }
      }
      for (std::size_t c = 0; c < 3; ++c) {
        // Transparent pixels keep a colour, which filtering may use.
        *out++ = opacity == 0 ? display[(plain_light[c] + area / 2) / area]
                              : display[(light[c] + opacity / 2) / opacity];
      }
      *out++ = static_cast<std::uint8_t>((opacity + area / 2) / area);
    }
  }
  return half;
}

std::vector<Picture> mipmapsOf(const Picture& full) {
  std::vector<Picture> levels;
  // At most 31 levels: growth of the vector must not move `last`.
  levels.reserve(32);
  const Picture* last = &full;
  while (last->width > 1 || last->height > 1) {
    levels.push_back(halved(*last));
    last = &levels.back();
  }
  return levels;
}

}  // namespace rocinante
