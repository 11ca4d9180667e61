// Loaded into emulated programs (tests/arm64/check): qemu-user knows the kernel's time stamps of
// received packets in microseconds (SO_TIMESTAMP) and not in nanoseconds (SO_TIMESTAMPNS), which is
// what the recorder asks for; of packets that the kernel dropped (SO_RXQ_OVFL, SO_MEMINFO) it knows
// nothing, and here none are.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <time.h>

int setsockopt(int fd, int level, int name, const void* value, socklen_t size) {
  int (*real)(int, int, int, const void*, socklen_t) = dlsym(RTLD_NEXT, "setsockopt");
  if (level == SOL_SOCKET && name == SO_TIMESTAMPNS) name = SO_TIMESTAMP;
  if (level == SOL_SOCKET && name == SO_RXQ_OVFL) return 0;
  return real(fd, level, name, value, size);
}

int getsockopt(int fd, int level, int name, void* value, socklen_t* size) {
  int (*real)(int, int, int, void*, socklen_t*) = dlsym(RTLD_NEXT, "getsockopt");
  if (level != SOL_SOCKET || name != SO_MEMINFO) return real(fd, level, name, value, size);
  memset(value, 0, *size);
  return 0;
}

static void inNanoseconds(struct msghdr* message) {
  for (struct cmsghdr* part = CMSG_FIRSTHDR(message); part != NULL; part = CMSG_NXTHDR(message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_TIMESTAMP) continue;
    struct timeval micro;
    memcpy(&micro, CMSG_DATA(part), sizeof micro);
    const struct timespec nano = {micro.tv_sec, micro.tv_usec * 1000};
    memcpy(CMSG_DATA(part), &nano, sizeof nano);
    part->cmsg_type = SCM_TIMESTAMPNS;
  }
}

ssize_t recvmsg(int fd, struct msghdr* message, int flags) {
  ssize_t (*real)(int, struct msghdr*, int) = dlsym(RTLD_NEXT, "recvmsg");
  const ssize_t received = real(fd, message, flags);
  if (received >= 0) inNanoseconds(message);
  return received;
}

int recvmmsg(int fd, struct mmsghdr* messages, unsigned count, int flags, struct timespec* within) {
  int (*real)(int, struct mmsghdr*, unsigned, int, struct timespec*) = dlsym(RTLD_NEXT, "recvmmsg");
  const int received = real(fd, messages, count, flags, within);
  for (int i = 0; i < received; ++i) inNanoseconds(&messages[i].msg_hdr);
  return received;
}
