/* Follows the updates of update_script.h on standard input with the C header, and writes every
 * datagram, with its size in a line before it, to standard output. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RK_SOURCE_IMPLEMENTATION
#include "core/source/rocinante/rocinante_source.h"

static char line[1 << 16];
static char *words[1024];
static double numbers[1024];

static int put(void *context, char *bytes, size_t size) {
  FILE *out = (FILE *)context;
  fprintf(out, "%lu\n", (unsigned long)size);
  return fwrite(bytes, 1, size, out) == size ? 0 : 1;
}

static const char *word(size_t at) { return strcmp(words[at], "-") == 0 ? NULL : words[at]; }

static size_t numbers_from(size_t at, size_t end) {
  size_t count = 0;
  for (; at < end; ++at) numbers[count++] = strtod(words[at], NULL);
  return count;
}

static int follow(rk_source *s, size_t count) {
  const char *verb = words[0];
  size_t i;
  if (strcmp(verb, "add") == 0) {
    const uint64_t kinematics = word(3) != NULL ? strtoul(words[3], NULL, 16) : 0;
    return rk_source_add(s, rk_source_device(s, words[1]), words[2],
                         word(3) != NULL ? &kinematics : NULL);
  }
  if (strcmp(verb, "remove") == 0) return rk_source_remove(s, rk_source_device(s, words[1]));
  if (strcmp(verb, "order") == 0) {
    const char *names[1024];
    for (i = 2; i < count; ++i) names[i - 2] = words[i];
    return rk_source_order(s, rk_source_device(s, words[1]), names, count - 2);
  }
  if (strcmp(verb, "joints") == 0) {
    return rk_source_joints(s, rk_source_device(s, words[1]), numbers, numbers_from(2, count));
  }
  if (strcmp(verb, "pose") == 0) {
    numbers_from(2, 9);
    return rk_source_pose(s, rk_source_device(s, words[1]), numbers,
                          rk_path_of(word(9), word(10), NULL));
  }
  if (strcmp(verb, "show") == 0) {
    return rk_source_show(s, rk_path_of(word(2), word(3), word(4)), (rk_shown)atoi(words[1]));
  }
  if (strcmp(verb, "color") == 0) {
    const rk_path path = rk_path_of(word(1), word(2), word(3));
    if (word(4) == NULL) return rk_source_color_default(s, path);
    return rk_source_color(s, path, (uint32_t)strtoul(words[4], NULL, 16));
  }
  if (strcmp(verb, "signal") == 0) {
    const rk_path path = rk_path_of(word(1), word(2), NULL);
    if (strcmp(words[4], "bool") == 0) {
      return rk_source_signal_bool(s, path, words[3], words[5][0] == '1');
    }
    if (strcmp(words[4], "text") == 0) return rk_source_signal_text(s, path, words[3], words[5]);
    if (strcmp(words[4], "default") == 0) return rk_source_signal_default(s, path, words[3]);
    return rk_source_signal(s, path, words[3], strtod(words[5], NULL), word(6), 0);
  }
  if (strcmp(verb, "line") == 0 || strcmp(verb, "points") == 0) {
    const rk_path carrier = rk_path_of(word(4), word(5), NULL);
    const uint32_t rgba = (uint32_t)strtoul(words[2], NULL, 16);
    const size_t points = numbers_from(6, count) / 3;
    const double size = strtod(words[3], NULL);
    return verb[0] == 'l' ? rk_source_line(s, words[1], rgba, size, carrier, numbers, points)
                          : rk_source_points(s, words[1], rgba, size, carrier, numbers, points);
  }
  if (strcmp(verb, "label") == 0) {
    numbers_from(4, 7);
    return rk_source_label(s, words[1], rk_path_of(word(2), word(3), NULL), numbers, words[7]);
  }
  if (strcmp(verb, "erase") == 0) {
    return rk_source_erase(s, strcmp(words[1], "*") == 0 ? NULL : words[1]);
  }
  if (strcmp(verb, "view") == 0) {
    rk_view view;
    numbers_from(2, 13);
    memcpy(view.eye, numbers, sizeof view.eye);
    memcpy(view.target, numbers + 3, sizeof view.target);
    view.fov_deg = numbers[6];
    memcpy(view.up, numbers + 7, sizeof view.up);
    view.ortho_height_m = numbers[10];
    return rk_source_view(s, words[1], &view, rk_path_of(word(13), word(14), NULL));
  }
  if (strcmp(verb, "event") == 0) return rk_source_event(s, words[1]);
  return rk_source_flush(s, (int64_t)strtoll(words[1], NULL, 10));
}

int main(void) {
  static char memory[1 << 20];
  rk_source_config config = {NULL, NULL, 0, 0, 0, NULL, NULL};
  rk_source *source;
  config.source = "s";
  config.run = "r";
  config.restate_ns = 2000000000;
  config.send = put;
  config.context = stdout;
  source = rk_source_open(memory, sizeof memory, &config, NULL);
  if (source == NULL) return 1;
  while (fgets(line, sizeof line, stdin) != NULL) {
    size_t count = 0;
    char *at = strtok(line, " \n");
    for (; at != NULL && count < 1024; at = strtok(NULL, " \n")) words[count++] = at;
    if (count > 0) follow(source, count);
  }
  return 0;
}
