// Loaded before a program (LD_PRELOAD), it moves the program's wall clock as settimeofday would
// move the system's: CLOCK_REALTIME and the kernel's timestamps on datagrams alike, by the
// nanoseconds in the file ROCINANTE_TEST_CLOCK. Time namespaces do not cover this clock, and a test
// must not set the machine's.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <time.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace {

std::int64_t offsetNs() {
  static const volatile std::int64_t* const shared = [] {
    const char* path = std::getenv("ROCINANTE_TEST_CLOCK");
    void* memory = MAP_FAILED;
    if (path != nullptr) {
      memory =
          ::mmap(nullptr, sizeof(std::int64_t), PROT_READ, MAP_SHARED, ::open(path, O_RDONLY), 0);
    }
    return memory == MAP_FAILED ? nullptr : static_cast<const volatile std::int64_t*>(memory);
  }();
  return shared == nullptr ? 0 : *shared;
}

void move(timespec& time) {
  const std::int64_t moved = time.tv_sec * 1'000'000'000 + time.tv_nsec + offsetNs();
  time.tv_sec = moved / 1'000'000'000;
  time.tv_nsec = moved % 1'000'000'000;
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static const auto real = next<int (*)(clockid_t, timespec*)>("clock_gettime");
  const int answer = real(clock, time);
  if (answer == 0 && clock == CLOCK_REALTIME) move(*time);
  return answer;
}

extern "C" int recvmmsg(int socket, mmsghdr* headers, unsigned count, int flags,
                        timespec* timeout) {
  static const auto real = next<int (*)(int, mmsghdr*, unsigned, int, timespec*)>("recvmmsg");
  const int received = real(socket, headers, count, flags, timeout);
  for (int i = 0; i < received; ++i) {
    for (cmsghdr* each = CMSG_FIRSTHDR(&headers[i].msg_hdr); each != nullptr;
         each = CMSG_NXTHDR(&headers[i].msg_hdr, each)) {
      if (each->cmsg_level != SOL_SOCKET || each->cmsg_type != SCM_TIMESTAMPNS) continue;
      timespec stamp{};
      std::memcpy(&stamp, CMSG_DATA(each), sizeof stamp);
      move(stamp);
      std::memcpy(CMSG_DATA(each), &stamp, sizeof stamp);
    }
  }
  return received;
}
