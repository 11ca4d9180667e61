// Loads one generated OBJ file of 998,000 triangles with points, texture coordinates and normals in
// four ways, turn by turn, and prints the best CPU time of each with its ratio to the bare loop.

#include <fast_float/fast_float.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/mesh/mesh_file.h"
#include "tests/support/temporary_folder.h"

#ifdef ROCINANTE_BENCH_ASSIMP
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#endif

namespace {

constexpr int kWide = 998, kHigh = 500;
constexpr std::size_t kTriangles = std::size_t{kWide} * kHigh * 2;

void writeHills(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) std::abort();
  std::fputs("o hills\n", file);
  for (int y = 0; y <= kHigh; ++y) {
    for (int x = 0; x <= kWide; ++x) {
      const double height = std::sin(x * 0.05) * std::cos(y * 0.07);
      std::fprintf(file, "v %.6f %.6f %.6f\n", x * 0.01, y * 0.01, height * 0.3);
      std::fprintf(file, "vt %.6f %.6f\n", x / double{kWide}, y / double{kHigh});
      std::fprintf(file, "vn %.4f %.4f %.4f\n", std::sin(x * 0.05), std::cos(y * 0.07), 0.7);
    }
  }
  for (int y = 0; y < kHigh; ++y) {
    for (int x = 0; x < kWide; ++x) {
      const int a = y * (kWide + 1) + x + 1, b = a + 1, c = b + kWide + 1, d = c - 1;
      std::fprintf(file, "f %d/%d/%d %d/%d/%d %d/%d/%d\n", a, a, a, b, b, b, c, c, c);
      std::fprintf(file, "f %d/%d/%d %d/%d/%d %d/%d/%d\n", a, a, a, c, c, c, d, d, d);
    }
  }
  if (std::fclose(file) != 0) std::abort();
}

/// The inner job and nothing else: no check, no fault, no group, no material.
std::size_t loadBare(const std::filesystem::path& path, bool index) {
  struct Key {
    int v, t, n;
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t h = static_cast<std::uint64_t>(key.v) * 0x9E3779B97F4A7C15U;
      h ^= static_cast<std::uint64_t>(key.t) * 0xC2B2AE3D27D4EB4FU;
      return static_cast<std::size_t>(h ^ static_cast<std::uint64_t>(key.n) * 0x165667B19E3779F9U);
    }
  };
  const int file = ::open(path.c_str(), O_RDONLY);
  struct stat facts {};
  ::fstat(file, &facts);
  const auto size = static_cast<std::size_t>(facts.st_size);
  void* mapped = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  if (mapped == MAP_FAILED) std::abort();
  const char* at = static_cast<const char*>(mapped);
  const char* const end = at + size;
  std::vector<float> v, vt, vn;
  std::vector<Key> corners;
  std::unordered_map<Key, std::uint32_t, Hash> numbers;
  std::vector<std::uint32_t> indices;
  const auto numbersInto = [&](std::vector<float>& to, int count) {
    for (int i = 0; i < count; ++i) {
      while (*at == ' ') ++at;
      float value = 0;
      at = fast_float::from_chars(at, end, value).ptr;
      to.push_back(value);
    }
  };
  while (at < end) {
    if (at[0] == 'v' && at[1] == ' ') {
      numbersInto(v, (at += 2, 3));
    } else if (at[0] == 'v' && at[1] == 't') {
      numbersInto(vt, (at += 3, 2));
    } else if (at[0] == 'v' && at[1] == 'n') {
      numbersInto(vn, (at += 3, 3));
    } else if (at[0] == 'f') {
      at += 2;
      for (int i = 0; i < 3; ++i) {
        Key key{};
        at = std::from_chars(at, end, key.v).ptr + 1;
        at = std::from_chars(at, end, key.t).ptr + 1;
        at = std::from_chars(at, end, key.n).ptr + 1;
        if (index) {
          const auto next = static_cast<std::uint32_t>(numbers.size());
          indices.push_back(numbers.emplace(key, next).first->second);
        } else {
          corners.push_back(key);
        }
      }
      continue;  // past the line's end already
    }
    while (at < end && *at != '\n') ++at;
    ++at;
  }
  ::munmap(mapped, size);
  ::close(file);
  return (index ? indices.size() : corners.size()) / 3;
}

double cpuMilliseconds(const std::function<std::size_t()>& load) {
  timespec before{}, after{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &before);
  if (load() != kTriangles) std::abort();
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &after);
  return static_cast<double>(after.tv_sec - before.tv_sec) * 1e3 +
         static_cast<double>(after.tv_nsec - before.tv_nsec) / 1e6;
}

}  // namespace

int main() {
  using namespace rocinante;
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder / "hills.obj";
  writeHills(path);

  struct Way {
    const char* name;
    std::function<std::size_t()> load;
    double best = 1e300;
  };
  std::vector<Way> ways;
  ways.push_back({"bare mmap + from_chars", [&] { return loadBare(path, false); }});
  ways.push_back({"the same + hash indexing", [&] { return loadBare(path, true); }});
  ways.push_back({"rocinante", [&] {
                    Findings faults;
                    const Result<Mesh> mesh = readMeshFile(path, {}, faults);
                    return mesh ? mesh->triangleCount() : 0;
                  }});
#ifdef ROCINANTE_BENCH_ASSIMP
  ways.push_back({"assimp, joined vertices", [&] {
                    Assimp::Importer importer;
                    const aiScene* scene = importer.ReadFile(
                        path.string(), aiProcess_Triangulate | aiProcess_JoinIdenticalVertices);
                    return scene == nullptr ? 0 : std::size_t{scene->mMeshes[0]->mNumFaces};
                  }});
#endif
  for (int round = 0; round < 5; ++round) {
    for (Way& way : ways) way.best = std::min(way.best, cpuMilliseconds(way.load));
  }
  std::printf("OBJ, %zu triangles, %ju bytes; best of 5, CPU ms, ratio to the bare loop\n",
              kTriangles, static_cast<std::uintmax_t>(std::filesystem::file_size(path)));
  for (const Way& way : ways) {
    std::printf("%-26s %8.1f %6.2f\n", way.name, way.best, way.best / ways.front().best);
  }
  return 0;
}
