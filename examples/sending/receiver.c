/* Prints each `joints` line that differs from the last one of its device; needs nothing of Rocinante.
 * cc -std=c99 receiver.c -o receiver && ./receiver 127.0.0.1 19960 [CHANGES] */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
static struct { char key[256], text[2048]; } table[1024]; /* by SOURCE its SEQUENCE, by device its line */

static char *text_of(const char *key) { /* empty for a new key */
  int i = 0;
  while (i < 1023 && table[i].key[0] && strcmp(table[i].key, key) != 0) ++i;
  if (strcmp(table[i].key, key) != 0) table[i].text[0] = '\0';
  snprintf(table[i].key, sizeof table[i].key, "%s", key);
  return table[i].text;
}

int main(int count, char **arguments) {
  static char bytes[65536], name[256], number[32];
  struct sockaddr_in at = {.sin_family = AF_INET};
  socklen_t size = sizeof at;
  int in = socket(AF_INET, SOCK_DGRAM, 0), left = count > 3 ? atoi(arguments[3]) : -1;
  if (count < 3 || inet_pton(AF_INET, arguments[1], &at.sin_addr) != 1) return 2;
  at.sin_port = htons((unsigned short)atoi(arguments[2]));
  if (bind(in, (struct sockaddr *)&at, size) != 0) return perror("bind"), 2;
  getsockname(in, (struct sockaddr *)&at, &size);
  for (printf("listening on %d\n", ntohs(at.sin_port)); left != 0;) {
    fflush(stdout);
    const ssize_t length = recv(in, bytes, sizeof bytes - 1, 0);
    bytes[length < 0 ? 0 : length] = '\0';
    if (sscanf(bytes, "RK1 %255s %31s", name, number) != 2) continue;
    const long behind = number[0] == '-' || !*text_of(name) ? -1 : atol(text_of(name)) - atol(number);
    if (behind >= 0 && behind <= 64 && atol(number) > 0) continue; /* late; further behind: restarted */
    if (number[0] != '-') strcpy(text_of(name), number);
    for (char *line = strtok(bytes, "\n"); line && left != 0; line = strtok(NULL, "\n"))
      if (sscanf(line, "joints %255s", name) == 1 && strncmp(text_of(strcat(name, " ")), line, 2047) != 0)
        snprintf(text_of(name), 2048, "%s", line), puts(line), left -= left > 0;
  }
}
