/* Prints the `joints` lines of every device as they change; needs nothing of Rocinante.
 *   cc -std=c99 receiver.c -o receiver && ./receiver 127.0.0.1 19960 [CHANGES] */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SOURCES = 64, DEVICES = 1024 };
static struct { char name[256]; long long highest; } sources[SOURCES];
static struct { char line[2048]; size_t head; } devices[DEVICES];

/* False for a late or repeated datagram; one further behind is of a source that was restarted. */
static int is_newer(const char *source, long long sequence) {
  int i = 0;
  while (i < SOURCES - 1 && sources[i].name[0] && strcmp(sources[i].name, source) != 0) ++i;
  const int known = strcmp(sources[i].name, source) == 0; /* RUN is part of the name here */
  const long long behind = sources[i].highest - sequence;
  if (known && sequence > 0 && behind >= 0 && behind <= 64) return 0;
  snprintf(sources[i].name, sizeof sources[i].name, "%s", source);
  sources[i].highest = sequence;
  return 1;
}

/* True when this `joints PATH ...` line is not the last one of its PATH. */
static int is_change(const char *line) {
  const size_t head = 7 + strcspn(line + 7, " ");
  int i = 0;
  while (i < DEVICES - 1 && devices[i].head &&
         (devices[i].head != head || memcmp(devices[i].line, line, head) != 0)) ++i;
  if (devices[i].head == head && strcmp(devices[i].line, line) == 0) return 0;
  snprintf(devices[i].line, sizeof devices[i].line, "%s", line);
  devices[i].head = head;
  return 1;
}

int main(int count, char **arguments) {
  static char bytes[65536];
  struct sockaddr_in at = {.sin_family = AF_INET};
  socklen_t size = sizeof at;
  const int in = socket(AF_INET, SOCK_DGRAM, 0);
  long left = count > 3 ? atol(arguments[3]) : -1;
  if (count < 3 || inet_pton(AF_INET, arguments[1], &at.sin_addr) != 1) return 2;
  at.sin_port = htons((unsigned short)atoi(arguments[2]));
  if (bind(in, (struct sockaddr *)&at, size) != 0) return perror("bind"), 2;
  getsockname(in, (struct sockaddr *)&at, &size);
  printf("listening on %d\n", ntohs(at.sin_port));
  while (left != 0) {
    char source[256], sequence[32];
    fflush(stdout);
    const ssize_t length = recv(in, bytes, sizeof bytes - 1, 0);
    if (length < 0) return perror("recv"), 1;
    bytes[length] = '\0';
    if (sscanf(bytes, "RK1 %255s %31s", source, sequence) != 2) continue;
    if (sequence[0] != '-' && !is_newer(source, atoll(sequence))) continue;
    for (char *line = strtok(bytes, "\n"); line && left != 0; line = strtok(NULL, "\n"))
      if (strncmp(line, "joints ", 7) == 0 && is_change(line)) puts(line), left -= left > 0;
  }
  return 0;
}
