/* Moves an arm of two joints and restates everything every 2 s. -I is for a clone without an installation:
 * cc -std=c99 -I../../core/source sender.c -o sender && ./sender 127.0.0.1 19960 [CYCLES] */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>
#define RK_SOURCE_IMPLEMENTATION
#include <rocinante/rocinante_source.h>

static int to_socket(void *context, char *bytes, size_t size) {
  return write(*(int *)context, bytes, size) == (ssize_t)size ? 0 : 1;
}

int main(int count, char **arguments) {
  static char memory[RK_SOURCE_BYTES(1, 2)];
  static const char *const names[] = {"shoulder", "elbow"};
  const struct timespec cycle = {0, 10000000};
  struct sockaddr_in to = {.sin_family = AF_INET};
  int out = socket(AF_INET, SOCK_DGRAM, 0), cycles = count > 3 ? atoi(arguments[3]) : -1;
  if (count < 3 || inet_pton(AF_INET, arguments[1], &to.sin_addr) != 1) return 2;
  to.sin_port = htons((unsigned short)atoi(arguments[2]));
  if (connect(out, (struct sockaddr *)&to, sizeof to) != 0) return 2;
  char run[24];
  snprintf(run, sizeof run, "%ld", (long)time(NULL));
  const rk_source_config config = {"sim", run, 2000000000, 0, 0, to_socket, &out};
  rk_source *source = rk_source_open(memory, sizeof memory, &config, NULL);
  const rk_device arm = rk_source_device(source, "arm");
  int result = rk_source_order(source, arm, names, 2);
  for (int i = 0; i != cycles && result == RK_OK; ++i) {
    const double joints[] = {0.004 * (i % 200), 0.006 * (i % 200)};
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    result = rk_source_joints(source, arm, joints, 2);
    if (result == RK_OK) rk_source_flush(source, now.tv_sec * 1000000000LL + now.tv_nsec);
    nanosleep(&cycle, NULL);
  }
  return result == RK_OK ? 0 : (fprintf(stderr, "%s\n", rk_result_text(result)), 1);
}
