// Opens a large cell in fresh processes: loaded from its files, baked while it is loaded for the
// first time, and from the cache. Each opening ends with every picture decoded, as the renderer
// needs them. usage: load_bench [CELL]    without one: the waste yard of the real data

#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <set>

#include "core/cli/worker_threads.h"
#include "tests/support/temporary_folder.h"
#include "viewer/bake/cell_cache.h"
#include "viewer/picture/picture.h"

namespace {

using namespace rocinante;

struct Cost {
  double wall_ms = 1e300, cpu_ms = 1e300;
};

double clockMs(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

void decodePictures(const Cell& cell) {
  std::set<std::filesystem::path> seen;
  for (const auto& [name, model] : cell.models) {
    for (const Link& link : model->links) {
      for (const Visual& visual : link.visuals) {
        if (!visual.mesh) continue;
        for (const Material& material : visual.mesh->materials) {
          const auto& file = material.diffuse_map;
          if (file.empty() || !seen.insert(file).second) continue;
          const auto at_hand = cell.pictures.find(file);
          const auto picture =
              at_hand != cell.pictures.end() ? decodePicture(at_hand->second, file.string())
              : material.diffuse_bytes       ? decodePicture(*material.diffuse_bytes, file.string())
                                             : readPicture(file);
          if (!picture.ok()) std::abort();
        }
      }
    }
  }
}

/// In a process of its own: libraries that decode are loaded once in each.
Cost openOnce(const std::filesystem::path& path, const CellCache& cache) {
  int ends[2];
  if (::pipe(ends) != 0) std::abort();
  const pid_t child = ::fork();
  if (child == 0) {
    const double wall = clockMs(CLOCK_MONOTONIC), cpu = clockMs(CLOCK_PROCESS_CPUTIME_ID);
    CellOptions options;
    options.parallel = cli::workerThreads();
    const auto cell = cache.load(path, options);
    if (!cell.ok()) {
      std::fprintf(stderr, "%s\n", cell.error().text().c_str());
      std::_Exit(1);
    }
    decodePictures(*cell);
    const Cost cost{clockMs(CLOCK_MONOTONIC) - wall, clockMs(CLOCK_PROCESS_CPUTIME_ID) - cpu};
    std::_Exit(::write(ends[1], &cost, sizeof cost) == sizeof cost ? 0 : 1);
  }
  ::close(ends[1]);
  Cost cost;
  if (::read(ends[0], &cost, sizeof cost) != sizeof cost) std::exit(1);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return cost;
}

}  // namespace

int main(int count, char** arguments) {
  const std::filesystem::path path = count > 1 ? std::filesystem::path(arguments[1])
                                               : std::filesystem::path(ROCINANTE_SHARED_DIR) /
                                                     "data/env/waste_yard/waste_yard.obj";
  if (!std::filesystem::exists(path)) {
    std::printf("no real data here: %s\n", path.c_str());
    return 77;
  }
  const test::TemporaryFolder folder;
  const CellCache none, cache(folder / "cells");
  struct Way {
    const char* name;
    std::function<Cost()> open;
    Cost best{};
  };
  const auto emptied = [&] {
    std::filesystem::remove_all(folder / "cells");
    return openOnce(path, cache);
  };
  Way ways[] = {{"from its files", [&] { return openOnce(path, none); }},
                {"and baked into the cache", emptied},
                {"from the cache", [&] { return openOnce(path, cache); }}};
  for (int round = 0; round < 7; ++round) {
    for (Way& way : ways) {
      const Cost cost = way.open();
      way.best = {std::min(way.best.wall_ms, cost.wall_ms), std::min(way.best.cpu_ms, cost.cpu_ms)};
    }
  }
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "cells")) {
    bytes += entry.file_size();
  }
  std::printf("%s with all pictures decoded, baked %ju bytes; best of 7, ms, ratio of time\n",
              path.filename().c_str(), bytes);
  std::printf("%-26s %8s %8s\n", "", "time", "CPU");
  for (const Way& way : ways) {
    std::printf("%-26s %8.1f %8.1f %6.2f\n", way.name, way.best.wall_ms, way.best.cpu_ms,
                way.best.wall_ms / ways[0].best.wall_ms);
  }
  return 0;
}
