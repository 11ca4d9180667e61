// Folds a whole log, as the viewer of a page does, some times; prints JSON: the shortest time in
// ms, messages, and the state's hash. tests/web/fold compares it with a browser's.
//
// usage: fold_natively LOG [TIMES]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "core/base/atomic_file.h"
#include "viewer/web/web_fold.h"

int main(int argc, char** argv) {
  using namespace rocinante;
  using Clock = std::chrono::steady_clock;
  if (argc < 2) return 2;
  const auto log = readFile(argv[1]);
  if (!log) return std::fprintf(stderr, "%s\n", log.error().text().c_str()), 2;
  double shortest_ms = 1e12;
  WholeFold whole;
  for (int left = argc > 2 ? std::atoi(argv[2]) : 3; left > 0; --left) {
    const auto begun = Clock::now();
    const auto folded = foldWhole(bytesOf(*log));
    if (!folded) return std::fprintf(stderr, "%s\n", folded.error().text().c_str()), 2;
    whole = *folded;
    const std::chrono::duration<double, std::milli> took = Clock::now() - begun;
    shortest_ms = std::min(shortest_ms, took.count());
  }
  std::printf("{\"ms\": %.3f, \"messages\": %llu, \"applied\": %llu, \"state\": \"%s\"}\n",
              shortest_ms, static_cast<unsigned long long>(whole.messages),
              static_cast<unsigned long long>(whole.applied), whole.state.c_str());
}
