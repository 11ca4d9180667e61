/* rocinante_source.h: sends kinematic state as packet text (docs/packet-format.md), for
 * controllers.
 *
 * One header in C99, also C++: no heap, no threads, no files, no clock, no libm. In one file of the
 * program:
 *
 *     #define RK_SOURCE_IMPLEMENTATION
 *     #include <rocinante/rocinante_source.h>
 *
 * and everywhere else without the define. With RK_SOURCE_STATIC defined as well, all functions are
 * static, and only that file can use them.
 *
 * The caller declares devices, sets their state every cycle and calls rk_source_flush(): what
 * changed goes out in datagrams, and every `restate_ns` everything is said again, spread over 0.5
 * s, for receivers that joined late or lost something (section "Restatements" of that page).
 *
 * Units: metres, radians, nanoseconds; x forward, y left, z up; quaternions are qx qy qz qw.
 * Numbers are sent with nine decimals, correctly rounded (ties to even), without trailing zeros.
 * They must be finite and below 2^53 = 9007199254740992 in magnitude; others are refused
 * (RK_BAD_NUMBER). Those of signals only need to be finite, and have the fewest digits that read
 * back as the same number: 0.1, 1e-12. Names and texts are UTF-8 ended by a NUL, and copied.
 *
 * Every function is bounded in time; setting is O(values), flushing O(what changed), and the flush
 * that begins a restatement O(items). At most 6 KB of stack. A source is used by one thread at a
 * time; different sources share nothing. A refused call changes nothing. */
#ifndef RK_SOURCE_H
#define RK_SOURCE_H

#include <stddef.h>
#include <stdint.h>

#ifdef RK_SOURCE_STATIC
#define RK_SOURCE_API static inline
#else
#define RK_SOURCE_API extern
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What functions return: 0, or why not. rk_result_text() gives the sentence. */
typedef enum rk_result {
  RK_OK = 0,
  RK_BAD_NAME = -1,
  RK_BAD_NUMBER = -2,
  RK_BAD_TEXT = -3,
  RK_BAD_POSE = -4,
  RK_BAD_ARGUMENT = -5,
  RK_NO_DEVICE = -6,
  RK_WRONG_COUNT = -7,
  RK_ORDER_FIXED = -8,
  RK_TOO_LONG = -9,
  RK_FULL = -10,
  RK_NOT_SENT = -11,
  RK_GONE = -12
} rk_result;

/* A source; it lives in the memory given to rk_source_open(). */
typedef struct rk_source rk_source;

/* A device of a source: 0 or more, or an rk_result, which every function hands back. Valid until
 * rk_source_forget(). */
typedef int32_t rk_device;

/* Sends one datagram; 0 when it was sent. `bytes` is valid during the call and has `reserved_bytes`
 * writable bytes behind `size`, for example for a signature. A datagram that was not sent is lost
 * like any other: the next restatement makes up for it. */
typedef int (*rk_send)(void *context, char *bytes, size_t size);

typedef struct rk_source_config {
  const char *source;    /* SOURCE: who speaks */
  const char *run;       /* RUN, chosen anew at each start; NULL: none */
  int64_t restate_ns;    /* time between restatements; 0: never */
  size_t max_datagram;   /* largest datagram; 0: 1200 */
  size_t reserved_bytes; /* kept free behind each datagram, beyond max_datagram */
  rk_send send;
  void *context; /* handed to `send` */
} rk_source_config;

/* Enough memory for this many devices with this many joints in all, with poses, an order and
 * names of up to 15 bytes, at 1,200 bytes a datagram. */
#define RK_SOURCE_BYTES(devices, joints) \
  ((size_t)12288 + (size_t)(devices)*1024 + (size_t)(joints)*96)

/* NULL when a name is wrong, max_datagram leaves no room for a statement, or the memory is too
 * small; `result` (may be NULL) says which. `memory` needs no alignment, and must stay until the
 * source is used no more; nothing else is to be released. */
RK_SOURCE_API rk_source *rk_source_open(void *memory, size_t bytes, const rk_source_config *config,
                                        int *result);

/* The device of this name, declared when it is new: nothing is said by it. At most 65,536. */
RK_SOURCE_API rk_device rk_source_device(rk_source *source, const char *name);

/* The device exists; MODEL is a name that the cell knows. `kinematics`, the hash of its kinematics,
 * may be NULL. */
RK_SOURCE_API int rk_source_add(rk_source *source, rk_device device, const char *model,
                                const uint64_t *kinematics);
/* The device is gone with everything said about it, by any source. Until it is added again, nothing
 * else can be said about it (RK_GONE). */
RK_SOURCE_API int rk_source_remove(rk_source *source, rk_device device);
/* Says nothing about the device any more, and frees its memory: receivers forget what this source
 * said about it with the next restatement. Call rk_source_remove() first if it is gone. */
RK_SOURCE_API int rk_source_forget(rk_source *source, rk_device device);

/* Which joints rk_source_joints() means, by name and all different. Once, before the first joints
 * of the device, and anew after it was removed; RK_ORDER_FIXED otherwise. Without it the values are
 * positions in the model's file. */
RK_SOURCE_API int rk_source_order(rk_source *source, rk_device device, const char *const *names,
                                  size_t count);
/* RK_WRONG_COUNT when the device has an order of another count. */
RK_SOURCE_API int rk_source_joints(rk_source *source, rk_device device, const double *values,
                                   size_t count);

/* What a colour or a visibility applies to, or what carries a pose: the views are borrowed. */
typedef struct rk_path {
  const char *device; /* NULL: the world, or a layer */
  const char *link;   /* NULL: the whole device */
  const char *layer;
} rk_path;

static inline rk_path rk_path_of(const char *device, const char *link, const char *layer) {
  rk_path path;
  path.device = device;
  path.link = link;
  path.layer = layer;
  return path;
}
static inline rk_path rk_world(void) { return rk_path_of(NULL, NULL, NULL); }
static inline rk_path rk_whole(const char *device) { return rk_path_of(device, NULL, NULL); }
static inline rk_path rk_link(const char *device, const char *link) {
  return rk_path_of(device, link, NULL);
}
static inline rk_path rk_layer(const char *layer) { return rk_path_of(NULL, NULL, layer); }

/* `pose`: x y z qx qy qz qw in the world or in the carrier, a link. RK_BAD_POSE when the
 * quaternion's length is not 1 within 0.001. */
RK_SOURCE_API int rk_source_pose(rk_source *source, rk_device device, const double pose[7],
                                 rk_path carrier);

/* Says the joints and the pose of the device with the next flush although they did not change: a
 * sign of life. */
RK_SOURCE_API int rk_source_repeat(rk_source *source, rk_device device);

typedef enum rk_shown { RK_SHOWN, RK_HIDDEN, RK_AS_THE_CELL } rk_shown;
RK_SOURCE_API int rk_source_show(rk_source *source, rk_path path, rk_shown shown);
/* 0xRRGGBBAA. */
RK_SOURCE_API int rk_source_color(rk_source *source, rk_path path, uint32_t rgba);
RK_SOURCE_API int rk_source_color_default(rk_source *source, rk_path path);

/* What the machine says beside where it is (docs/packet-format.md, "Signals"), of a device, a link,
 * or rk_world() for neither. A number goes out when it differs by more than `deadband` from the one
 * sent last, and is restated as it is; `unit` (1 to 32 printable ASCII bytes without spaces and
 * quotes) may be NULL: the one it has, or none. */
RK_SOURCE_API int rk_source_signal(rk_source *source, rk_path path, const char *name, double value,
                                   const char *unit, double deadband);
RK_SOURCE_API int rk_source_signal_bool(rk_source *source, rk_path path, const char *name,
                                        int value);
RK_SOURCE_API int rk_source_signal_text(rk_source *source, rk_path path, const char *name,
                                        const char *text);
/* Says nothing about the signal any more; receivers may have one of an earlier run. */
RK_SOURCE_API int rk_source_signal_default(rk_source *source, rk_path path, const char *name);

/* Drawings share their ids; setting one again replaces it. `xyz` has three numbers a point, at
 * least one point. Long ones are sent in parts, at most 4,096. `size_px`: width of a line, size of
 * points. */
RK_SOURCE_API int rk_source_line(rk_source *source, const char *id, uint32_t rgba, double size_px,
                                 rk_path carrier, const double *xyz, size_t points);
RK_SOURCE_API int rk_source_points(rk_source *source, const char *id, uint32_t rgba, double size_px,
                                   rk_path carrier, const double *xyz, size_t points);
RK_SOURCE_API int rk_source_label(rk_source *source, const char *id, rk_path carrier,
                                  const double xyz[3], const char *text);
/* No such drawing is no fault: receivers may have one of an earlier run. NULL: all of them. */
RK_SOURCE_API int rk_source_erase(rk_source *source, const char *id);

typedef struct rk_view {
  double eye[3], target[3]; /* at least 2e-9 m apart */
  double fov_deg;           /* vertical, over 0 and under 180 */
  double up[3];             /* not 0 0 0 */
  double ortho_height_m;    /* 0: perspective */
} rk_view;
RK_SOURCE_API int rk_source_view(rk_source *source, const char *name, const rk_view *view,
                                 rk_path carrier);

/* Sent with the next flush, once. */
RK_SOURCE_API int rk_source_event(rk_source *source, const char *text);

/* Sends what changed, then the parts of a restatement that are due. `now_ns`: since the epoch,
 * becomes TIME; it should be called at least ten times a second, or restatements come in bursts.
 * RK_NOT_SENT when `send` refused a datagram; the others were sent all the same. */
RK_SOURCE_API int rk_source_flush(rk_source *source, int64_t now_ns);
/* The same with another TIME than the clock that restatements are timed by; below 0: `-`. */
RK_SOURCE_API int rk_source_flush_at(rk_source *source, int64_t now_ns, int64_t time_ns);

/* When the next part of a restatement is due, on the clock of `now_ns`; INT64_MAX: not yet known.
 */
RK_SOURCE_API int64_t rk_source_due(const rk_source *source);
/* Datagrams given to `send` so far: the next SEQUENCE. */
RK_SOURCE_API uint64_t rk_source_sent(const rk_source *source);
/* A sentence for a result, without a full stop; never NULL. */
RK_SOURCE_API const char *rk_result_text(int result);

/* `number` as packets have it, with a NUL; its length, or 0 when it is refused. `text` has 32
 * bytes. */
RK_SOURCE_API size_t rk_number_text(char *text, double number);

#ifdef __cplusplus
}
#endif
#endif /* RK_SOURCE_H */

#if defined(RK_SOURCE_IMPLEMENTATION) && !defined(RK_SOURCE_IMPLEMENTED)
#define RK_SOURCE_IMPLEMENTED
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  RK_NAME_BYTES = 255,
  RK_STRING_BYTES = 4096,
  RK_VALUES_MOST = 4096, /* joints of a statement; parts of a drawing */
  RK_PARTS_MOST = 65536,
  RK_DEVICES_MOST = 65536,
  RK_NUMBER_BYTES = 28,   /* the longest number with the space before it */
  RK_ENCODED_BYTES = 765, /* the longest name, percent-encoded */
  RK_KEY_BYTES = 2 * RK_ENCODED_BYTES + 8,
  RK_SIGNAL_KEY_BYTES = 3 * RK_ENCODED_BYTES + 8,
  RK_UNIT_BYTES = 32,
  RK_HEADER_BYTES = 84, /* the longest header after SOURCE@RUN */
  RK_LEAST_LINE = 24,
  RK_CLASSES = 26 /* blocks of 32 << class bytes: up to 1 GiB */
};
static const int64_t rk_spread_ns = 500000000; /* over which a restatement is spread */
static const int64_t rk_expiry_ns = 900000000; /* receivers give up after 1 s */
static const int64_t rk_never = INT64_MAX;

/* ---- Numbers and names as text. Each writes at `at` and returns the end. ---- */

static inline char *rk_put_bytes(char *at, const char *bytes, size_t size) {
  if (size > 0) memcpy(at, bytes, size);
  return at + size;
}

static inline char *rk_put_word(char *at, const char *word) {
  while (*word != '\0') *at++ = *word++;
  return at;
}

static inline char *rk_put_unsigned(char *at, uint64_t number) {
  char digits[20];
  size_t begin = sizeof digits;
  do {
    digits[--begin] = (char)('0' + number % 10);
    number /= 10;
  } while (number != 0);
  return rk_put_bytes(at, digits + begin, sizeof digits - begin);
}

/* A point and the nine decimals of `units` billionths, without trailing zeros; nothing for 0. */
static inline char *rk_put_decimals(char *at, uint32_t units) {
  static const char pairs[] =
      "00010203040506070809101112131415161718192021222324252627282930313233343536373839"
      "40414243444546474849505152535455565758596061626364656667686970717273747576777879"
      "8081828384858687888990919293949596979899";
  uint32_t high, low;
  if (units == 0) return at;
  high = units / 10000;
  low = units % 10000;
  at[0] = '.';
  at[1] = (char)('0' + high / 10000);
  high %= 10000;
  memcpy(at + 2, pairs + 2 * (high / 100), 2);
  memcpy(at + 4, pairs + 2 * (high % 100), 2);
  memcpy(at + 6, pairs + 2 * (low / 100), 2);
  memcpy(at + 8, pairs + 2 * (low % 100), 2);
  at += 10;
  while (at[-1] == '0') --at;
  return at;
}

/* False for infinities, numbers of 2^53 and more, and what is not a number. */
static inline int rk_is_number(double number) {
  return number > -9007199254740992.0 && number < 9007199254740992.0;
}

/* The exact value is mantissa / 2^shift, so its billionths are rounded as integers. */
static inline char *rk_put_number(char *at, double number) {
  const uint64_t one = 1;
  uint64_t bits, mantissa, whole, fraction, low, middle, high, units, rest, half;
  unsigned exponent, shift;
  int round_up;
  memcpy(&bits, &number, sizeof bits);
  exponent = (unsigned)(bits >> 52) & 0x7FF;
  mantissa = (bits & ((one << 52) - 1)) | (one << 52);
  shift = 1075 - exponent;
  if (shift >= 84) { /* below 2^-31, less than half a billionth */
    *at = '0';
    return at + 1;
  }
  whole = shift < 53 ? mantissa >> shift : 0;
  fraction = shift < 53 ? mantissa & ((one << shift) - 1) : mantissa;
  /* fraction * 10^9 has up to 83 bits: high, low. */
  low = (fraction & 0xFFFFFFFFu) * 1000000000u;
  middle = (fraction >> 32) * 1000000000u + (low >> 32);
  low = (middle << 32) | (low & 0xFFFFFFFFu);
  high = middle >> 32;
  if (shift == 0) {
    units = 0;
    round_up = 0;
  } else if (shift < 64) {
    units = (high << (64 - shift)) | (low >> shift);
    rest = low & ((one << shift) - 1);
    half = one << (shift - 1);
    round_up = rest > half || (rest == half && (units & 1) != 0);
  } else if (shift == 64) {
    units = high;
    round_up = low > one << 63 || (low == one << 63 && (units & 1) != 0);
  } else {
    units = high >> (shift - 64);
    rest = high & ((one << (shift - 64)) - 1);
    half = one << (shift - 65);
    round_up = rest > half || (rest == half && (low != 0 || (units & 1) != 0));
  }
  if (round_up && ++units == 1000000000u) {
    units = 0;
    ++whole;
  }
  if ((bits >> 63) != 0 && (whole != 0 || units != 0)) *at++ = '-';
  if (whole < 10) {
    *at++ = (char)('0' + whole);
  } else {
    at = rk_put_unsigned(at, whole);
  }
  return rk_put_decimals(at, (uint32_t)units);
}

/* ---- Numbers of signals: exact, with the fewest digits. ---- */

/* The largest have 1,140 bits: the smallest number, scaled to its first digit. */
enum { RK_LONG_WORDS = 37 };
typedef struct rk_long {
  uint32_t words[RK_LONG_WORDS]; /* the lowest first; those from `used` on are unset */
  int used;
} rk_long;

static inline void rk_long_times(rk_long *number, uint32_t factor) {
  uint64_t carry = 0;
  int i;
  for (i = 0; i < number->used; ++i) {
    carry += (uint64_t)number->words[i] * factor;
    number->words[i] = (uint32_t)carry;
    carry >>= 32;
  }
  if (carry != 0) number->words[number->used++] = (uint32_t)carry;
}

static inline void rk_long_times_ten_to(rk_long *number, int power) {
  for (; power >= 9; power -= 9) rk_long_times(number, 1000000000u);
  for (; power > 0; --power) rk_long_times(number, 10);
}

/* mantissa * 2^power */
static inline rk_long rk_long_of(uint64_t mantissa, int power) {
  rk_long number;
  number.used = 0;
  for (; power >= 32; power -= 32) number.words[number.used++] = 0;
  number.words[number.used++] = (uint32_t)mantissa;
  number.words[number.used++] = (uint32_t)(mantissa >> 32);
  rk_long_times(&number, (uint32_t)1 << power);
  while (number.used > 0 && number.words[number.used - 1] == 0) --number.used;
  return number;
}

static inline uint32_t rk_long_word(const rk_long *number, int place) {
  return place < number->used ? number->words[place] : 0;
}

/* The sign of a + b - c. */
static inline int rk_long_sum_compare(const rk_long *a, const rk_long *b, const rk_long *c) {
  int place = a->used > b->used ? a->used : b->used;
  int64_t rest = 0; /* of c above, in units of this word */
  if (c->used > place) place = c->used;
  while (--place >= 0) {
    rest = rest * ((int64_t)1 << 32) + rk_long_word(c, place) - (int64_t)rk_long_word(a, place) -
           rk_long_word(b, place);
    if (rest > 2) return -1; /* the words below carry less than 2 */
    if (rest < 0) return 1;
  }
  return rest > 0 ? -1 : 0;
}

/* a -= b, which is not larger. */
static inline void rk_long_subtract(rk_long *a, const rk_long *b) {
  uint64_t borrow = 0;
  int i;
  for (i = 0; i < a->used; ++i) {
    const uint64_t less = rk_long_word(b, i) + borrow;
    borrow = a->words[i] < less;
    a->words[i] -= (uint32_t)less;
  }
  while (a->used > 0 && a->words[a->used - 1] == 0) --a->used;
}

/* The fewest digits that read back as the same finite number above 0, of those the nearest; at most
 * 17. Returns how many; the number is 0.DIGITS * 10^point. After Steele and White, "How to print
 * floating-point numbers accurately", 1990: the number is rest / unit, and its neighbours are 2 *
 * above and 2 * below away. */
static inline int rk_digits(double number, char *digits, int *point) {
  const rk_long zero = {{0}, 0};
  rk_long rest, unit, above, below;
  uint64_t bits, mantissa;
  int exponent, is_even, is_lowest, length, count = 0, power;
  memcpy(&bits, &number, sizeof bits);
  exponent = (int)(bits >> 52 & 0x7FF);
  mantissa = bits & 0xFFFFFFFFFFFFFu;
  is_even = (mantissa & 1) == 0;
  is_lowest = mantissa == 0 && exponent > 1; /* the number below is half as far away */
  if (exponent > 0) mantissa |= (uint64_t)1 << 52;
  exponent = (exponent > 0 ? exponent : 1) - 1075;
  for (length = 0; length < 53 && mantissa >> length != 0;) ++length;
  rest = rk_long_of(mantissa << 2, exponent > 0 ? exponent : 0);
  above = rk_long_of(2, exponent > 0 ? exponent : 0);
  below = rk_long_of(is_lowest ? 1 : 2, exponent > 0 ? exponent : 0);
  unit = rk_long_of(4, exponent < 0 ? -exponent : 0);
  /* Of the first digit; perhaps one too low. log10(2) = 0.30103. */
  power = (exponent + length - 1) * 30103;
  power = power < 0 ? -((99999 - power) / 100000) : power / 100000;
  if (power > 0) rk_long_times_ten_to(&unit, power);
  if (power < 0) {
    rk_long_times_ten_to(&rest, -power);
    rk_long_times_ten_to(&above, -power);
    rk_long_times_ten_to(&below, -power);
  }
  for (;;) {
    rk_long ten_units = unit;
    rk_long_times(&ten_units, 10);
    if (rk_long_sum_compare(&rest, &above, &ten_units) < (is_even ? 0 : 1)) break;
    unit = ten_units;
    ++power;
  }
  *point = power + 1;
  for (;;) {
    char digit = '0';
    int is_low_enough, is_high_enough;
    while (rk_long_sum_compare(&rest, &zero, &unit) >= 0) {
      rk_long_subtract(&rest, &unit);
      ++digit;
    }
    is_low_enough = rk_long_sum_compare(&rest, &zero, &below) < (is_even ? 1 : 0);
    is_high_enough = rk_long_sum_compare(&rest, &above, &unit) >= (is_even ? 0 : 1);
    if (is_low_enough || is_high_enough) {
      const int half = rk_long_sum_compare(&rest, &rest, &unit);
      if (!is_low_enough || (is_high_enough && (half > 0 || (half == 0 && (digit & 1) != 0)))) {
        ++digit;
      }
    }
    digits[count++] = digit;
    if (is_low_enough || is_high_enough) return count;
    rk_long_times(&rest, 10);
    rk_long_times(&above, 10);
    rk_long_times(&below, 10);
  }
}

static inline int rk_is_finite(double number) {
  return number >= -1.7976931348623157e308 && number <= 1.7976931348623157e308;
}

/* With an exponent below 1e-5 and from 2^53 on. */
static inline char *rk_put_exact(char *at, double number) {
  const double size = number < 0 ? -number : number;
  char digits[20];
  int count, point, i;
  if (size < 9007199254740992.0) {
    /* Without rounding, nine decimals of at most 15 digits are the shortest. */
    if (size == (double)(uint64_t)size) return rk_put_number(at, number);
    if (size >= 1e-5 && size < 1e6 && (double)(uint64_t)(size * 1e9 + 0.5) / 1e9 == size) {
      return rk_put_number(at, number);
    }
  }
  count = rk_digits(size, digits, &point);
  if (number < 0) *at++ = '-';
  if (size >= 1e-5 && size < 9007199254740992.0) {
    if (point <= 0) at = rk_put_word(at, "0.");
    for (i = point; i < 0; ++i) *at++ = '0';
    for (i = 0; i < count; ++i) {
      if (i == point && i > 0) *at++ = '.';
      *at++ = digits[i];
    }
    return at;
  }
  *at++ = digits[0];
  if (count > 1) *at++ = '.';
  at = rk_put_bytes(at, digits + 1, (size_t)count - 1);
  *at++ = 'e';
  if (point < 1) *at++ = '-';
  return rk_put_unsigned(at, (uint64_t)(point < 1 ? 1 - point : point - 1));
}

static inline size_t rk_numbers_size(const double *values, size_t count) {
  char scratch[32];
  size_t size = 0, i;
  for (i = 0; i < count; ++i) size += 1 + (size_t)(rk_put_number(scratch, values[i]) - scratch);
  return size;
}

static inline char *rk_put_numbers(char *at, const double *values, size_t count) {
  size_t i;
  for (i = 0; i < count; ++i) {
    *at++ = ' ';
    at = rk_put_number(at, values[i]);
  }
  return at;
}

static inline char *rk_put_hex(char *at, uint64_t number, int digits) {
  int shift;
  for (shift = (digits - 1) * 4; shift >= 0; shift -= 4) {
    *at++ = "0123456789abcdef"[(number >> shift) & 15];
  }
  return at;
}

static inline char *rk_put_color(char *at, uint32_t rgba) {
  at = rk_put_word(at, " #");
  return (rgba & 0xFF) == 0xFF ? rk_put_hex(at, rgba >> 8, 6) : rk_put_hex(at, rgba, 8);
}

/* The length of the UTF-8 sequence at `text`, which ends with a NUL; 0 when it is malformed.
 * Unicode 15, table 3-7: no overlong forms, no surrogates, nothing past U+10FFFF. */
static inline size_t rk_utf8_length(const char *text) {
  const unsigned char *at = (const unsigned char *)text;
  unsigned low = 0x80, high = 0xBF;
  size_t length, i;
  if (at[0] < 0x80) return 1;
  if (at[0] < 0xC2 || at[0] > 0xF4) return 0;
  length = at[0] < 0xE0 ? 2 : at[0] < 0xF0 ? 3 : 4;
  if (at[0] == 0xE0) low = 0xA0;
  if (at[0] == 0xED) high = 0x9F;
  if (at[0] == 0xF0) low = 0x90;
  if (at[0] == 0xF4) high = 0x8F;
  if (at[1] < low || at[1] > high) return 0;
  for (i = 2; i < length; ++i) {
    if ((at[i] & 0xC0) != 0x80) return 0;
  }
  return length;
}

static inline int rk_is_control(char byte) {
  return (unsigned char)byte < 0x20 || (unsigned char)byte == 0x7F;
}

static inline int rk_is_plain(char byte) {
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
         (byte >= '0' && byte <= '9') || byte == '_' || byte == '.' || byte == '-' || byte == ':';
}

/* Percent-encodes a name, at most RK_ENCODED_BYTES; NULL when it is none. */
static inline char *rk_put_name(char *at, const char *name) {
  size_t size = 0, length, i;
  if (at == NULL || name == NULL || name[0] == '\0') return NULL;
  for (; *name != '\0'; name += length) {
    length = rk_utf8_length(name);
    size += length;
    if (length == 0 || size > RK_NAME_BYTES || rk_is_control(*name)) return NULL;
    for (i = 0; i < length; ++i) {
      if (rk_is_plain(name[i])) {
        *at++ = name[i];
      } else {
        *at++ = '%';
        *at++ = "0123456789ABCDEF"[(unsigned char)name[i] >> 4];
        *at++ = "0123456789ABCDEF"[(unsigned char)name[i] & 15];
      }
    }
  }
  return at;
}

/* Quotes and escapes a text; `end` bounds it. NULL when it is none or there is no room. */
static inline char *rk_put_string(char *at, const char *end, const char *text) {
  size_t size = 0, length;
  if (text == NULL || end - at < 2) return NULL;
  *at++ = '"';
  for (; *text != '\0'; text += length) {
    length = rk_utf8_length(text);
    size += length;
    if (length == 0 || size > RK_STRING_BYTES || end - at < 6) return NULL;
    if (rk_is_control(*text) && *text != '\t' && *text != '\n') return NULL;
    if (*text == '"' || *text == '\\' || *text == '\n') {
      *at++ = '\\';
      *at++ = *text == '\n' ? 'n' : *text;
    } else {
      at = rk_put_bytes(at, text, length);
    }
  }
  *at++ = '"';
  return at;
}

/* ---- Items: one thing said each, with the line that says it. ---- */

typedef enum rk_kind {
  RK_DEVICE, /* presence; also the device itself */
  RK_ORDER,
  RK_JOINTS,
  RK_POSE,
  RK_VISIBILITY,
  RK_COLOR,
  RK_SIGNAL,
  RK_DRAWING,
  RK_VIEW,
  RK_EVENT, /* sent once, then freed, like the next */
  RK_ERASURE,
  RK_CANCELLATION /* of a signal */
} rk_kind;

/* The form of an item: what kind of value it has. */
enum { RK_NOTHING, RK_ADDED, RK_REMOVED }; /* of a device */
enum { RK_COLORED, RK_COLOR_OF_CELL };     /* of a colour */
enum { RK_LINE, RK_POINTS, RK_LABEL };     /* of a drawing */
enum { RK_NUMBER, RK_BOOL, RK_TEXT };      /* of a signal */
enum { RK_WHOLE = 2 };

typedef struct rk_item rk_item;
typedef struct rk_slot rk_slot;
struct rk_item {
  /* What every change of joints reads and writes, together: thousands of devices do not fit the
   * processor's caches. */
  rk_item *next_queued; /* changed items, in the order in which they are sent */
  rk_slot *slot;        /* of the device that it belongs to or is; NULL: of none */
  double *values;
  const char *key; /* the encoded name or path, behind this struct */
  uint32_t key_size, value_count;
  uint32_t line_bytes; /* as last written */
  uint8_t kind, form;
  uint8_t is_queued, is_dead;

  char *text; /* MODEL, names, carrier, then a string */
  uint32_t text_size, carrier_size;
  rk_item *before, *after; /* in the order of restatements; a device's items follow it */
  rk_item *next_in_bucket;
  uint32_t rgba;                   /* of a number: the restatement since which its unit was said */
  uint32_t part_index, part_count; /* of a drawing; RK_WHOLE: a number's next line has its unit */
  uint32_t part;                   /* of the restatement under way; 0: none */
  uint32_t hash;
  uint8_t item_class, value_class, text_class; /* sizes of its blocks */
  uint8_t was_removed;                         /* a device: `remove` must be sent first */
};

/* A device and its items of which there is one at most. */
struct rk_slot {
  rk_item *device; /* NULL: free */
  rk_item *order, *joints, *pose;
  int32_t next_free, handle;
  uint32_t order_round; /* the restatement since which the order was said */
};

struct rk_source {
  rk_source_config config;
  char *at, *end; /* memory never used so far */
  void *free_blocks[RK_CLASSES];
  rk_item **buckets;
  uint32_t bucket_mask;
  rk_slot *slots;
  int32_t slot_count, slots_used, free_slot;
  rk_item *first, *last, *queue_first, *queue_last;

  /* A datagram being written, and the line that may be one too many; between flushes the numbers
   * of a drawing's part, which have at most four times the bytes of their text. */
  char *buffer;
  size_t used, header_bytes;
  char prefix[2 * RK_ENCODED_BYTES + 8], time_text[24];
  size_t prefix_bytes, time_bytes, line_most;
  uint64_t sequence;
  int is_open, has_failed;

  /* Restating. */
  int has_flushed, is_restating, is_careful;
  int64_t last_flush, next_round, round_began;
  uint32_t round; /* its number, the ID of its parts */
  uint32_t parts, parts_sent;
  rk_item *cursor; /* the first item of the parts that are not sent yet */
};

static inline unsigned rk_class_of(size_t bytes) {
  unsigned size_class = 0;
  while (size_class < RK_CLASSES && ((size_t)32 << size_class) < bytes) ++size_class;
  return size_class;
}

static inline void *rk_take(rk_source *s, size_t bytes, uint8_t *size_class) {
  const unsigned wanted = rk_class_of(bytes);
  void *block;
  if (wanted >= RK_CLASSES) return NULL;
  *size_class = (uint8_t)wanted;
  block = s->free_blocks[wanted];
  if (block != NULL) {
    memcpy(&s->free_blocks[wanted], block, sizeof block);
    return block;
  }
  if ((size_t)(s->end - s->at) < (size_t)32 << wanted) return NULL;
  block = s->at;
  s->at += (size_t)32 << wanted;
  return block;
}

static inline void rk_give(rk_source *s, void *block, uint8_t size_class) {
  if (block == NULL) return;
  memcpy(block, &s->free_blocks[size_class], sizeof block);
  s->free_blocks[size_class] = block;
}

static inline void rk_free_item(rk_source *s, rk_item *item) {
  rk_give(s, item->values, item->value_class);
  rk_give(s, item->text, item->text_class);
  rk_give(s, item, item->item_class);
}

static inline uint32_t rk_hash(rk_kind kind, uint32_t part_index, const char *key, size_t size) {
  uint32_t hash = 2166136261u ^ (uint32_t)kind ^ (part_index << 8);
  size_t i;
  for (i = 0; i < size; ++i) hash = (hash ^ (unsigned char)key[i]) * 16777619u;
  return hash ^ (hash >> 15);
}

static inline rk_item *rk_find(const rk_source *s, rk_kind kind, uint32_t part_index,
                               const char *key, size_t size) {
  const uint32_t hash = rk_hash(kind, part_index, key, size);
  rk_item *item = s->buckets[hash & s->bucket_mask];
  for (; item != NULL; item = item->next_in_bucket) {
    if (item->hash == hash && item->kind == kind && item->part_index == part_index &&
        item->key_size == size && memcmp(item->key, key, size) == 0) {
      return item;
    }
  }
  return NULL;
}

/* An item that is not in any list yet; NULL when the memory is full. */
static inline rk_item *rk_new_item(rk_source *s, rk_kind kind, const char *key, size_t size) {
  uint8_t size_class;
  char *copy;
  rk_item *item = (rk_item *)rk_take(s, sizeof *item + size, &size_class);
  if (item == NULL) return NULL;
  memset(item, 0, sizeof *item);
  copy = (char *)(item + 1);
  memcpy(copy, key, size);
  item->key = copy;
  item->key_size = (uint32_t)size;
  item->item_class = size_class;
  item->kind = (uint8_t)kind;
  item->part_index = item->part_count = 1;
  return item;
}

/* Puts it behind `before`, or at the end when that is NULL. */
static inline void rk_link_item(rk_source *s, rk_item *item, rk_item *before) {
  rk_item **bucket;
  if (before == NULL) before = s->last;
  item->before = before;
  item->after = before != NULL ? before->after : NULL;
  if (item->after != NULL) {
    item->after->before = item;
  } else {
    s->last = item;
  }
  if (before != NULL) {
    before->after = item;
  } else {
    s->first = item;
  }
  item->hash = rk_hash((rk_kind)item->kind, item->part_index, item->key, item->key_size);
  bucket = &s->buckets[item->hash & s->bucket_mask];
  item->next_in_bucket = *bucket;
  *bucket = item;
}

/* Takes it out of the state; its memory is free now, or when its turn in the queue comes. */
static inline void rk_kill(rk_source *s, rk_item *item) {
  rk_item **bucket = &s->buckets[item->hash & s->bucket_mask];
  while (*bucket != item) bucket = &(*bucket)->next_in_bucket;
  *bucket = item->next_in_bucket;
  if (item->before != NULL) {
    item->before->after = item->after;
  } else {
    s->first = item->after;
  }
  if (item->after != NULL) {
    item->after->before = item->before;
  } else {
    s->last = item->before;
  }
  if (s->cursor == item) s->cursor = item->after;
  if (item->is_queued) {
    item->is_dead = 1;
  } else {
    rk_free_item(s, item);
  }
}

static inline void rk_queue(rk_source *s, rk_item *item) {
  if (item->is_queued) return;
  item->is_queued = 1;
  item->next_queued = NULL;
  if (s->queue_last != NULL) {
    s->queue_last->next_queued = item;
  } else {
    s->queue_first = item;
  }
  s->queue_last = item;
}

/* ---- Lines ---- */

static inline char *rk_put_carrier(char *at, const rk_item *item) {
  if (item->carrier_size == 0) return at;
  at = rk_put_word(at, " in ");
  return rk_put_bytes(at, item->text, item->carrier_size);
}

static inline char *rk_put_key(char *at, const char *word, const rk_item *item) {
  at = rk_put_word(at, word);
  *at++ = ' ';
  return rk_put_bytes(at, item->key, item->key_size);
}

static inline char *rk_put_drawing(char *at, const rk_item *item) {
  if (item->form == RK_LABEL) {
    at = rk_put_carrier(rk_put_key(at, "label", item), item);
    at = rk_put_numbers(at, item->values, 3);
    *at++ = ' ';
    return rk_put_bytes(at, item->text + item->carrier_size, item->text_size - item->carrier_size);
  }
  at = rk_put_key(at, item->form == RK_LINE ? "line" : "points", item);
  if (item->part_count != 1) {
    *at++ = ':';
    at = rk_put_unsigned(at, item->part_index);
    *at++ = '/';
    at = rk_put_unsigned(at, item->part_count);
  }
  at = rk_put_color(at, item->rgba);
  at = rk_put_word(at, item->form == RK_LINE ? " width=" : " size=");
  at = rk_put_number(at, item->values[0]);
  at = rk_put_carrier(at, item);
  return rk_put_numbers(at, item->values + 1, item->value_count - 1);
}

/* The second value is the number that was sent last. */
static inline char *rk_put_signal(char *at, const rk_item *item) {
  if (item->form == RK_NUMBER && item->part_count != RK_WHOLE) {
    at = rk_put_key(at, "signals", item);
    *at++ = '=';
    return rk_put_exact(at, item->values[0]);
  }
  at = rk_put_key(at, "signal", item);
  if (item->form == RK_BOOL) return rk_put_word(at, item->values[0] != 0 ? " true" : " false");
  if (item->form == RK_NUMBER) {
    *at++ = ' ';
    at = rk_put_exact(at, item->values[0]);
  }
  if (item->text_size == 0) return at;
  *at++ = ' ';
  return rk_put_bytes(at, item->text, item->text_size);
}

static inline char *rk_put_view(char *at, const rk_item *item) {
  const double *up = item->values + 7;
  at = rk_put_numbers(rk_put_key(at, "view", item), item->values, 7);
  if (up[0] != 0 || up[1] != 0 || up[2] != 1) at = rk_put_numbers(rk_put_word(at, " up"), up, 3);
  if (item->values[10] > 0) at = rk_put_numbers(rk_put_word(at, " ortho"), item->values + 10, 1);
  return rk_put_carrier(at, item);
}

/* The line of an item with its LF; none for a device of which nothing was said. */
static inline char *rk_put_line(char *at, const rk_item *item) {
  switch ((rk_kind)item->kind) {
    case RK_DEVICE:
      if (item->form == RK_NOTHING) return at;
      at = rk_put_key(at, item->form == RK_ADDED ? "add" : "remove", item);
      if (item->form == RK_ADDED) *at++ = ' ';
      at = rk_put_bytes(at, item->text, item->text_size);
      break;
    case RK_ORDER:
      at = rk_put_key(at, "order", item);
      at = rk_put_bytes(at, item->text, item->text_size);
      break;
    case RK_JOINTS:
      at = rk_put_key(at, "joints", item);
      at = rk_put_numbers(at, item->values, item->value_count);
      break;
    case RK_POSE:
      at = rk_put_key(at, "pose", item);
      at = rk_put_numbers(at, item->values, item->value_count);
      at = rk_put_carrier(at, item);
      break;
    case RK_VISIBILITY:
      at = rk_put_key(at, item->form == RK_HIDDEN ? "hide" : "show", item);
      if (item->form == RK_AS_THE_CELL) at = rk_put_word(at, " default");
      break;
    case RK_COLOR:
      at = rk_put_key(at, "color", item);
      at = item->form == RK_COLORED ? rk_put_color(at, item->rgba) : rk_put_word(at, " default");
      break;
    case RK_SIGNAL:
      at = rk_put_signal(at, item);
      break;
    case RK_CANCELLATION:
      at = rk_put_word(rk_put_key(at, "signal", item), " default");
      break;
    case RK_DRAWING:
      at = rk_put_drawing(at, item);
      break;
    case RK_VIEW:
      at = rk_put_view(at, item);
      break;
    case RK_EVENT:
      at = rk_put_bytes(rk_put_word(at, "event "), item->text, item->text_size);
      break;
    case RK_ERASURE:
      at = rk_put_key(at, "erase", item);
      break;
  }
  *at++ = '\n';
  return at;
}

/* No line of such an item is longer, its LF included. */
static inline size_t rk_line_bound(size_t key_size, size_t text_size, size_t value_count) {
  return 64 + key_size + text_size + value_count * RK_NUMBER_BYTES;
}

/* ---- Saying: a draft becomes an item's value when it fits and differs. ---- */

typedef struct rk_draft {
  uint8_t form;
  uint32_t rgba;
  const double *values;
  size_t value_count;
  const char *text;
  size_t text_size, carrier_size;
} rk_draft;

static inline rk_draft rk_draft_of(int form) {
  rk_draft draft;
  memset(&draft, 0, sizeof draft);
  draft.form = (uint8_t)form;
  return draft;
}

/* The draft's text is this one, quoted where datagrams are written. */
static inline int rk_draft_string(rk_source *s, rk_draft *draft, const char *text) {
  char *const begin = s->buffer;
  const char *const end = rk_put_string(begin, begin + s->line_most, text);
  if (end == NULL) {
    /* Too long for a datagram, or no text at all. */
    return text != NULL && strlen(text) <= RK_STRING_BYTES && strlen(text) > s->line_most / 2
               ? RK_TOO_LONG
               : RK_BAD_TEXT;
  }
  draft->text = begin;
  draft->text_size = (size_t)(end - begin);
  return RK_OK;
}

static inline int rk_check(const rk_source *s, rk_kind kind, size_t key_size,
                           const rk_draft *draft) {
  size_t i, bytes;
  if (kind == RK_SIGNAL) {
    /* Its next numbers are not measured: there is room for the longest. */
    bytes = rk_line_bound(key_size, draft->text_size, draft->form == RK_NUMBER ? 1 : 0);
    if (!rk_is_finite(draft->values[0])) return RK_BAD_NUMBER;
    return bytes <= s->line_most ? RK_OK : RK_TOO_LONG;
  }
  for (i = 0; i < draft->value_count; ++i) {
    if (!rk_is_number(draft->values[i])) return RK_BAD_NUMBER;
  }
  if (rk_line_bound(key_size, draft->text_size, draft->value_count) <= s->line_most) return RK_OK;
  bytes = rk_line_bound(key_size, draft->text_size, 0);
  bytes += rk_numbers_size(draft->values, draft->value_count);
  return bytes <= s->line_most ? RK_OK : RK_TOO_LONG;
}

static inline int rk_are_same(const double *values, const double *others, size_t count) {
  size_t i;
  for (i = 0; i < count; ++i) {
    if (values[i] != others[i]) return 0;
  }
  return 1;
}

static inline int rk_is_same(const rk_item *item, const rk_draft *draft) {
  if (item->form != draft->form || item->rgba != draft->rgba ||
      item->value_count != draft->value_count || item->text_size != draft->text_size ||
      item->carrier_size != draft->carrier_size) {
    return 0;
  }
  if (!rk_are_same(item->values, draft->values, draft->value_count)) return 0;
  return draft->text_size == 0 || memcmp(item->text, draft->text, draft->text_size) == 0;
}

/* Room for `bytes` at *block, whose contents are lost; an empty block has class 0. */
static inline int rk_make_room(rk_source *s, void **block, uint8_t *size_class, size_t bytes) {
  uint8_t new_class;
  void *room;
  if (bytes == 0 || (*block != NULL && bytes <= (size_t)32 << *size_class)) return 1;
  room = rk_take(s, bytes, &new_class);
  if (room == NULL) return 0;
  rk_give(s, *block, *size_class);
  *block = room;
  *size_class = new_class;
  return 1;
}

/* Copies the draft; the item is left as it was when the memory is full. */
static inline int rk_fill(rk_source *s, rk_item *item, const rk_draft *draft) {
  void *values = item->values, *text = item->text;
  const size_t value_bytes = draft->value_count * sizeof(double);
  uint8_t text_class = item->text_class, value_class = item->value_class;
  if (text == NULL || draft->text_size > (size_t)32 << text_class) {
    /* Both blocks or none. */
    text = NULL;
    if (!rk_make_room(s, &text, &text_class, draft->text_size)) return RK_FULL;
  }
  if (!rk_make_room(s, &values, &value_class, value_bytes)) {
    if (text != item->text) rk_give(s, text, text_class);
    return RK_FULL;
  }
  if (text != item->text && text != NULL) {
    rk_give(s, item->text, item->text_class);
    item->text = (char *)text;
    item->text_class = text_class;
  }
  item->values = (double *)values;
  item->value_class = value_class;
  item->form = draft->form;
  item->rgba = draft->rgba;
  item->value_count = (uint32_t)draft->value_count;
  item->text_size = (uint32_t)draft->text_size;
  item->carrier_size = (uint32_t)draft->carrier_size;
  if (value_bytes > 0) memcpy(item->values, draft->values, value_bytes);
  if (draft->text_size > 0) memcpy(item->text, draft->text, draft->text_size);
  return RK_OK;
}

/* Gives an item its value, and queues it when that changed. */
static inline int rk_say(rk_source *s, rk_item *item, const rk_draft *draft) {
  int result;
  if (rk_is_same(item, draft)) return RK_OK;
  result = rk_check(s, (rk_kind)item->kind, item->key_size, draft);
  if (result == RK_OK) result = rk_fill(s, item, draft);
  if (result == RK_OK) rk_queue(s, item);
  return result;
}

/* A new item with a value, behind `before` or at the end. */
static inline int rk_say_new(rk_source *s, rk_kind kind, const char *key, size_t key_size,
                             rk_slot *slot, rk_item *before, const rk_draft *draft,
                             rk_item **made) {
  rk_item *item;
  int result = rk_check(s, kind, key_size, draft);
  if (result != RK_OK) return result;
  item = rk_new_item(s, kind, key, key_size);
  if (item == NULL) return RK_FULL;
  result = rk_fill(s, item, draft);
  if (result != RK_OK) {
    rk_free_item(s, item);
    return result;
  }
  item->slot = slot;
  rk_link_item(s, item, before);
  rk_queue(s, item);
  if (made != NULL) *made = item;
  return RK_OK;
}

/* An item of a device of which there is one at most: its pose, order or joints. */
static inline int rk_say_of_device(rk_source *s, rk_kind kind, rk_slot *slot, rk_item **item,
                                   rk_item *before, const rk_draft *draft) {
  const rk_item *const device = slot->device;
  if (*item != NULL) return rk_say(s, *item, draft);
  return rk_say_new(s, kind, device->key, device->key_size, slot, before, draft, item);
}

/* ---- Opening, devices ---- */

RK_SOURCE_API const char *rk_result_text(int result) {
  static const char *const texts[] = {
      "done",
      "a name is not 1 to 255 bytes of UTF-8 without control characters",
      "a number is not finite or not below 2^53",
      "a text is longer than 4096 bytes, not UTF-8, or has control characters; or a unit is none",
      "the length of a quaternion differs from 1 by more than 0.001",
      "an argument is missing or out of range",
      "no such device: its handle was forgotten or never given",
      "the number of joints differs from that of the device's order",
      "the order of the joints cannot change before the device is removed",
      "the statement does not fit one datagram",
      "the memory given to the source is full",
      "a datagram could not be sent",
      "the device was removed: add it again first"};
  if (result > 0) result = 0;
  return result >= RK_GONE ? texts[-result] : "unknown result";
}

RK_SOURCE_API size_t rk_number_text(char *text, double number) {
  char *end;
  if (text == NULL || !rk_is_number(number)) return 0;
  end = rk_put_number(text, number);
  *end = '\0';
  return (size_t)(end - text);
}

/* `bytes` zeroed bytes for good; NULL when the memory is too small. */
static inline void *rk_reserve(rk_source *s, size_t bytes) {
  void *block = s->at;
  bytes = (bytes + 15) & ~(size_t)15;
  if ((size_t)(s->end - s->at) < bytes) return NULL;
  s->at += bytes;
  memset(block, 0, bytes);
  return block;
}

static inline int rk_begin(rk_source *s, const rk_source_config *config) {
  const size_t most = config->max_datagram == 0 ? 1200 : config->max_datagram;
  const size_t bytes = (size_t)(s->end - s->at);
  char *end;
  size_t buckets = 16;
  s->config = *config;
  s->config.max_datagram = most;
  end = rk_put_name(rk_put_word(s->prefix, "RK1 "), config->source);
  if (end != NULL && config->run != NULL) {
    *end++ = '@';
    end = rk_put_name(end, config->run);
  }
  if (end == NULL) return RK_BAD_NAME;
  *end++ = ' ';
  s->prefix_bytes = (size_t)(end - s->prefix);
  if (config->send == NULL || config->restate_ns < 0 || most > 65507 ||
      config->reserved_bytes > 65507 || most < s->prefix_bytes + RK_HEADER_BYTES + RK_LEAST_LINE) {
    return RK_BAD_ARGUMENT;
  }
  s->line_most = most - s->prefix_bytes - RK_HEADER_BYTES;
  while (buckets < bytes / 512 && buckets < (size_t)1 << 20) buckets *= 2;
  s->bucket_mask = (uint32_t)(buckets - 1);
  s->slot_count = bytes / 512 < RK_DEVICES_MOST ? (int32_t)(bytes / 512) : RK_DEVICES_MOST;
  s->free_slot = -1;
  s->buffer = (char *)rk_reserve(s, 4 * most + config->reserved_bytes + 64);
  s->buckets = (rk_item **)rk_reserve(s, buckets * sizeof *s->buckets);
  s->slots = (rk_slot *)rk_reserve(s, (size_t)s->slot_count * sizeof *s->slots);
  return s->buffer != NULL && s->buckets != NULL && s->slots != NULL ? RK_OK : RK_FULL;
}

RK_SOURCE_API rk_source *rk_source_open(void *memory, size_t bytes, const rk_source_config *config,
                                        int *result) {
  const size_t skipped = (16 - (size_t)((uintptr_t)memory & 15)) & 15;
  const size_t struct_bytes = (sizeof(rk_source) + 15) & ~(size_t)15;
  rk_source *s = NULL;
  int answer = RK_BAD_ARGUMENT;
  if (memory != NULL && config != NULL) {
    answer = RK_FULL;
    if (bytes >= skipped + struct_bytes) {
      s = (rk_source *)(void *)((char *)memory + skipped);
      memset(s, 0, sizeof *s);
      s->at = (char *)s + struct_bytes;
      s->end = (char *)memory + bytes;
      answer = rk_begin(s, config);
    }
  }
  if (result != NULL) *result = answer;
  return answer == RK_OK ? s : NULL;
}

static inline rk_slot *rk_slot_at(const rk_source *s, rk_device device) {
  const int32_t index = device & 0xFFFF;
  if (device < 0 || index >= s->slots_used || s->slots[index].handle != device) return NULL;
  return &s->slots[index];
}

static inline rk_item *rk_declare(rk_source *s, const char *key, size_t size, int *result) {
  rk_item *device = rk_find(s, RK_DEVICE, 1, key, size);
  int32_t index = s->free_slot;
  if (device != NULL) return device;
  *result = RK_FULL;
  if (index < 0 && s->slots_used == s->slot_count) return NULL;
  device = rk_new_item(s, RK_DEVICE, key, size);
  if (device == NULL) return NULL;
  if (index >= 0) {
    s->free_slot = s->slots[index].next_free;
  } else {
    index = s->slots_used++;
    s->slots[index].handle = index;
  }
  device->slot = &s->slots[index];
  device->slot->device = device;
  rk_link_item(s, device, NULL);
  return device;
}

RK_SOURCE_API rk_device rk_source_device(rk_source *source, const char *name) {
  char key[RK_ENCODED_BYTES];
  const char *end = rk_put_name(key, name);
  int result = RK_BAD_NAME;
  rk_item *device = end == NULL ? NULL : rk_declare(source, key, (size_t)(end - key), &result);
  return device != NULL ? device->slot->handle : result;
}

RK_SOURCE_API int rk_source_add(rk_source *source, rk_device device, const char *model,
                                const uint64_t *kinematics) {
  const rk_slot *const slot = rk_slot_at(source, device);
  rk_draft draft = rk_draft_of(RK_ADDED);
  char text[RK_ENCODED_BYTES + 24];
  char *end = rk_put_name(text, model);
  if (slot == NULL) return device < 0 ? device : RK_NO_DEVICE;
  if (end == NULL) return RK_BAD_NAME;
  if (kinematics != NULL) end = rk_put_hex(rk_put_word(end, " kin="), *kinematics, 16);
  draft.text = text;
  draft.text_size = (size_t)(end - text);
  return rk_say(source, slot->device, &draft);
}

static inline int rk_has_items(const rk_slot *slot) {
  return slot->device->after != NULL && slot->device->after->slot == slot;
}

/* Kills all items of a device but itself. */
static inline void rk_clear_device(rk_source *s, rk_slot *slot) {
  while (rk_has_items(slot)) rk_kill(s, slot->device->after);
  slot->order = slot->joints = slot->pose = NULL;
  slot->order_round = 0;
}

RK_SOURCE_API int rk_source_remove(rk_source *source, rk_device device) {
  rk_slot *const slot = rk_slot_at(source, device);
  rk_item *item;
  if (slot == NULL) return device < 0 ? device : RK_NO_DEVICE;
  item = slot->device;
  if (item->form == RK_REMOVED && !rk_has_items(slot)) return RK_OK;
  rk_clear_device(source, slot);
  item->form = RK_REMOVED;
  item->text_size = 0;
  item->was_removed = 1;
  rk_queue(source, item);
  return RK_OK;
}

RK_SOURCE_API int rk_source_forget(rk_source *source, rk_device device) {
  rk_slot *const slot = rk_slot_at(source, device);
  rk_item *item;
  if (slot == NULL) return device < 0 ? device : RK_NO_DEVICE;
  rk_clear_device(source, slot);
  item = slot->device;
  slot->device = NULL;
  /* The next one differs. */
  slot->handle = (int32_t)(((uint32_t)device + 0x10000u) & 0x7FFFFFFFu);
  slot->next_free = source->free_slot;
  source->free_slot = device & 0xFFFF;
  rk_kill(source, item);
  return RK_OK;
}

/* The device of which something is to be said. Were that allowed of a removed one, each restatement
 * would delete it for a while: `remove` and the rest may be in different parts. */
static inline rk_slot *rk_present_device(const rk_source *s, rk_device device, int *result) {
  rk_slot *const slot = rk_slot_at(s, device);
  *result = device < 0 ? device : slot == NULL ? RK_NO_DEVICE : RK_GONE;
  /* Of a removed device there are no joints. */
  if (slot == NULL || slot->joints != NULL) return slot;
  return slot->device->form == RK_REMOVED ? NULL : slot;
}

RK_SOURCE_API int rk_source_order(rk_source *source, rk_device device, const char *const *names,
                                  size_t count) {
  int result;
  rk_slot *const slot = rk_present_device(source, device, &result);
  rk_draft draft = rk_draft_of(RK_NOTHING);
  char *text, *at;
  size_t i, size;
  if (slot == NULL) return result;
  if (names == NULL || count == 0) return RK_BAD_ARGUMENT;
  if (count > RK_VALUES_MOST) return RK_TOO_LONG;
  /* Written where datagrams are, which is free between flushes. */
  text = at = source->buffer;
  for (i = 0; i < count; ++i) {
    char name[RK_ENCODED_BYTES];
    const char *other;
    const char *const end = rk_put_name(name, names[i]);
    if (end == NULL) return RK_BAD_NAME;
    size = (size_t)(end - name);
    if ((size_t)(at - text) + 1 + size > source->line_most) return RK_TOO_LONG;
    for (other = text; other < at;) {
      const char *last = other + 1;
      while (last < at && *last != ' ') ++last;
      if ((size_t)(last - other) == size + 1 && memcmp(other + 1, name, size) == 0) {
        return RK_BAD_ARGUMENT;
      }
      other = last;
    }
    *at++ = ' ';
    at = rk_put_bytes(at, name, size);
  }
  draft.text = text;
  draft.text_size = (size_t)(at - text);
  draft.rgba = (uint32_t)count;
  if (slot->order != NULL) return rk_is_same(slot->order, &draft) ? RK_OK : RK_ORDER_FIXED;
  return rk_say_of_device(source, RK_ORDER, slot, &slot->order, slot->device, &draft);
}

RK_SOURCE_API int rk_source_joints(rk_source *source, rk_device device, const double *values,
                                   size_t count) {
  int result;
  rk_slot *const slot = rk_present_device(source, device, &result);
  rk_draft draft = rk_draft_of(RK_NOTHING);
  if (slot == NULL) return result;
  if (values == NULL || count == 0) return RK_BAD_ARGUMENT;
  if (count > RK_VALUES_MOST) return RK_TOO_LONG;
  draft.values = values;
  draft.value_count = count;
  if (slot->joints != NULL && slot->joints->value_count == count) {
    /* What nearly every call is, with as little memory read as can be. */
    rk_item *const joints = slot->joints;
    if (rk_are_same(joints->values, values, count)) return RK_OK;
    result = rk_check(source, RK_JOINTS, joints->key_size, &draft);
    if (result != RK_OK) return result;
    memcpy(joints->values, values, count * sizeof *values);
    rk_queue(source, joints);
    return RK_OK;
  }
  if (slot->order == NULL) {
    /* Positions: an order that a receiver may know of an earlier run is cancelled first. */
    rk_draft none = rk_draft_of(RK_NOTHING);
    result = rk_check(source, RK_JOINTS, slot->device->key_size, &draft);
    if (result == RK_OK) {
      result = rk_say_of_device(source, RK_ORDER, slot, &slot->order, slot->device, &none);
    }
    if (result != RK_OK) return result;
    result = rk_say_of_device(source, RK_JOINTS, slot, &slot->joints, slot->order, &draft);
    if (result != RK_OK) {
      rk_kill(source, slot->order);
      slot->order = NULL;
    }
    return result;
  }
  if (slot->order->rgba != 0 && slot->order->rgba != count) return RK_WRONG_COUNT;
  return rk_say_of_device(source, RK_JOINTS, slot, &slot->joints, slot->order, &draft);
}

/* ---- Paths, poses, looks ---- */

/* The path as key; the device's name alone has `device_size` bytes, 0 for a layer. */
static inline char *rk_put_path(char *at, rk_path path, size_t *device_size) {
  char *const begin = at;
  *device_size = 0;
  if (path.layer != NULL) {
    if (path.device != NULL || path.link != NULL) return NULL;
    return rk_put_name(rk_put_word(at, "layer/"), path.layer);
  }
  at = rk_put_name(at, path.device);
  if (at == NULL) return NULL;
  *device_size = (size_t)(at - begin);
  if (path.link == NULL) return at;
  if (*device_size == 5 && memcmp(begin, "layer", 5) == 0) at = rk_put_word(begin, "%6Cayer");
  *at++ = '/';
  return rk_put_name(at, path.link);
}

/* "DEVICE/LINK", nothing for the world; NULL when it is neither. */
static inline char *rk_put_carrier_path(char *at, rk_path path) {
  if (path.device == NULL && path.link == NULL && path.layer == NULL) return at;
  if (path.layer != NULL) return NULL;
  at = rk_put_name(at, path.device);
  if (at != NULL) *at++ = '/';
  return rk_put_name(at, path.link);
}

RK_SOURCE_API int rk_source_pose(rk_source *source, rk_device device, const double pose[7],
                                 rk_path carrier) {
  int result;
  rk_slot *const slot = rk_present_device(source, device, &result);
  rk_draft draft = rk_draft_of(RK_NOTHING);
  char text[RK_KEY_BYTES];
  const char *end = rk_put_carrier_path(text, carrier);
  double square;
  size_t i;
  if (slot == NULL) return result;
  if (pose == NULL) return RK_BAD_ARGUMENT;
  if (end == NULL) return RK_BAD_NAME;
  for (i = 0; i < 7; ++i) {
    if (!rk_is_number(pose[i])) return RK_BAD_NUMBER;
  }
  square = pose[3] * pose[3] + pose[4] * pose[4] + pose[5] * pose[5] + pose[6] * pose[6];
  if (square < 0.998002 || square > 1.002) return RK_BAD_POSE;
  draft.values = pose;
  draft.value_count = 7;
  draft.text = text;
  draft.text_size = draft.carrier_size = (size_t)(end - text);
  return rk_say_of_device(source, RK_POSE, slot, &slot->pose, slot->device, &draft);
}

RK_SOURCE_API int rk_source_repeat(rk_source *source, rk_device device) {
  int result;
  rk_slot *const slot = rk_present_device(source, device, &result);
  if (slot == NULL) return result;
  if (slot->joints != NULL) rk_queue(source, slot->joints);
  if (slot->pose != NULL) rk_queue(source, slot->pose);
  return RK_OK;
}

/* A new item of the device of this name, or of none when that is NULL. */
static inline int rk_say_new_of(rk_source *s, rk_kind kind, const char *key, size_t size,
                                const char *device_name, const rk_draft *draft) {
  rk_item *device = NULL;
  int result = RK_OK;
  if (device_name != NULL) {
    /* `remove` concerns it, whether the device was declared or not. */
    char name[RK_ENCODED_BYTES];
    const char *end = rk_put_name(name, device_name);
    device = rk_declare(s, name, (size_t)(end - name), &result);
    if (device == NULL) return result;
    if (device->form == RK_REMOVED) return RK_GONE;
  }
  return rk_say_new(s, kind, key, size, device != NULL ? device->slot : NULL, device, draft, NULL);
}

static inline int rk_say_of_path(rk_source *s, rk_kind kind, rk_path path, const rk_draft *draft) {
  char key[RK_KEY_BYTES];
  size_t device_size, size;
  rk_item *item;
  const char *end = rk_put_path(key, path, &device_size);
  if (end == NULL) return RK_BAD_NAME;
  size = (size_t)(end - key);
  item = rk_find(s, kind, 1, key, size);
  if (item != NULL) return rk_say(s, item, draft);
  return rk_say_new_of(s, kind, key, size, device_size > 0 ? path.device : NULL, draft);
}

RK_SOURCE_API int rk_source_show(rk_source *source, rk_path path, rk_shown shown) {
  const rk_draft draft = rk_draft_of((int)shown);
  if (shown != RK_SHOWN && shown != RK_HIDDEN && shown != RK_AS_THE_CELL) return RK_BAD_ARGUMENT;
  return rk_say_of_path(source, RK_VISIBILITY, path, &draft);
}

RK_SOURCE_API int rk_source_color(rk_source *source, rk_path path, uint32_t rgba) {
  rk_draft draft = rk_draft_of(RK_COLORED);
  draft.rgba = rgba;
  return rk_say_of_path(source, RK_COLOR, path, &draft);
}

RK_SOURCE_API int rk_source_color_default(rk_source *source, rk_path path) {
  const rk_draft draft = rk_draft_of(RK_COLOR_OF_CELL);
  return rk_say_of_path(source, RK_COLOR, path, &draft);
}

/* ---- Drawings, views, events ---- */

/* Something sent once: an event's text or the key of an erasure. */
static inline int rk_say_once(rk_source *s, rk_kind kind, const char *key, size_t key_size,
                              const rk_draft *draft) {
  rk_item *item;
  int result = rk_check(s, kind, key_size, draft);
  if (result != RK_OK) return result;
  item = rk_new_item(s, kind, key, key_size);
  if (item == NULL) return RK_FULL;
  result = rk_fill(s, item, draft);
  if (result == RK_OK) {
    rk_queue(s, item);
  } else {
    rk_free_item(s, item);
  }
  return result;
}

/* ---- Signals ---- */

/* "PATH NAME"; NULL when one of them is no name. */
static inline char *rk_put_signal_key(char *at, rk_path path, const char *name) {
  char *const begin = at;
  size_t device_size;
  if (path.layer != NULL) return NULL;
  if (path.device == NULL && path.link == NULL) {
    at = rk_put_word(at, "-");
  } else {
    at = rk_put_path(at, path, &device_size);
    if (at == begin + 1 && *begin == '-') at = rk_put_word(begin, "%2D");
  }
  if (at != NULL) *at++ = ' ';
  return rk_put_name(at, name);
}

static inline int rk_say_signal(rk_source *s, rk_path path, const char *name, double deadband,
                                rk_draft *draft) {
  char key[RK_SIGNAL_KEY_BYTES];
  const char *const end = rk_put_signal_key(key, path, name);
  double values[2];
  rk_item *item;
  int result;
  if (end == NULL) return RK_BAD_NAME;
  values[0] = values[1] = draft->values[0];
  draft->values = values;
  draft->value_count = 2;
  item = rk_find(s, RK_SIGNAL, 1, key, (size_t)(end - key));
  if (item == NULL) {
    return rk_say_new_of(s, RK_SIGNAL, key, (size_t)(end - key), path.device, draft);
  }
  if (draft->form == RK_NUMBER && item->form == RK_NUMBER) {
    const double change = values[0] - item->values[1];
    const int is_unit_new =
        draft->text_size > 0 && (draft->text_size != item->text_size ||
                                 memcmp(draft->text, item->text, draft->text_size) != 0);
    if (!is_unit_new) {
      if (!rk_is_finite(values[0])) return RK_BAD_NUMBER;
      item->values[0] = values[0];
      if (change > deadband || change < -deadband) rk_queue(s, item);
      return RK_OK;
    }
  } else if (rk_is_same(item, draft)) {
    return RK_OK;
  }
  result = rk_say(s, item, draft);
  if (result == RK_OK) rk_queue(s, item);
  return result;
}

RK_SOURCE_API int rk_source_signal(rk_source *source, rk_path path, const char *name, double value,
                                   const char *unit, double deadband) {
  rk_draft draft = rk_draft_of(RK_NUMBER);
  if (!(deadband >= 0)) return RK_BAD_ARGUMENT;
  draft.values = &value;
  if (unit != NULL) {
    size_t size = 0;
    for (; unit[size] != '\0'; ++size) {
      if (size == RK_UNIT_BYTES || unit[size] <= ' ' || unit[size] > '~' || unit[size] == '"') {
        return RK_BAD_TEXT;
      }
    }
    if (size == 0) return RK_BAD_TEXT;
    draft.text = unit;
    draft.text_size = size;
  }
  return rk_say_signal(source, path, name, deadband, &draft);
}

RK_SOURCE_API int rk_source_signal_bool(rk_source *source, rk_path path, const char *name,
                                        int value) {
  const double number = value != 0 ? 1 : 0;
  rk_draft draft = rk_draft_of(RK_BOOL);
  draft.values = &number;
  return rk_say_signal(source, path, name, 0, &draft);
}

RK_SOURCE_API int rk_source_signal_text(rk_source *source, rk_path path, const char *name,
                                        const char *text) {
  const double nothing = 0;
  rk_draft draft = rk_draft_of(RK_TEXT);
  const int result = rk_draft_string(source, &draft, text);
  if (result != RK_OK) return result;
  draft.values = &nothing;
  return rk_say_signal(source, path, name, 0, &draft);
}

RK_SOURCE_API int rk_source_signal_default(rk_source *source, rk_path path, const char *name) {
  char key[RK_SIGNAL_KEY_BYTES];
  const char *const end = rk_put_signal_key(key, path, name);
  const rk_draft draft = rk_draft_of(RK_NOTHING);
  rk_item *item;
  int result;
  if (end == NULL) return RK_BAD_NAME;
  result = rk_say_once(source, RK_CANCELLATION, key, (size_t)(end - key), &draft);
  item = rk_find(source, RK_SIGNAL, 1, key, (size_t)(end - key));
  if (result == RK_OK && item != NULL) rk_kill(source, item);
  return result;
}

static inline void rk_kill_drawing(rk_source *s, rk_item *first) {
  rk_item *item = first;
  uint32_t left = first->part_count;
  for (; left > 0; --left) {
    rk_item *const next = item->after; /* the parts follow each other */
    rk_kill(s, item);
    item = next;
  }
}

/* Points of the next part: as many as fit a line with `fixed` other bytes. */
static inline size_t rk_points_of_part(const rk_source *s, size_t fixed, const double *xyz,
                                       size_t points) {
  size_t count = 0, bytes = fixed;
  for (; count < points; ++count) {
    bytes += rk_numbers_size(xyz + 3 * count, 3);
    if (bytes > s->line_most) break;
  }
  return count;
}

/* The values of a part: the size, then its points, gathered where datagrams are written. */
static inline void rk_draft_part(rk_source *s, rk_draft *draft, double size_px, const double *xyz,
                                 size_t points) {
  double *values = (double *)(void *)s->buffer;
  values[0] = size_px;
  if (points > 0) memcpy(values + 1, xyz, points * 3 * sizeof(double));
  draft->values = values;
  draft->value_count = 1 + 3 * points;
}

/* A drawing with other parts than before, or none before: all parts or nothing. */
static inline int rk_replace_drawing(rk_source *s, const char *key, size_t key_size,
                                     rk_draft *draft, double size_px, const double *xyz,
                                     size_t points, uint32_t parts, size_t fixed) {
  rk_item *old = rk_find(s, RK_DRAWING, 1, key, key_size), *first = NULL, *last = NULL, *item;
  uint32_t index;
  for (index = 1; index <= parts; ++index) {
    const size_t count = rk_points_of_part(s, fixed, xyz, points);
    int result = RK_FULL;
    rk_draft_part(s, draft, size_px, xyz, count);
    item = rk_new_item(s, RK_DRAWING, key, key_size);
    if (item != NULL) result = rk_fill(s, item, draft);
    if (result != RK_OK) {
      if (item != NULL) rk_free_item(s, item);
      while (first != NULL) {
        item = first->next_queued;
        rk_free_item(s, first);
        first = item;
      }
      return result;
    }
    item->part_index = index;
    item->part_count = parts;
    if (last != NULL) {
      last->next_queued = item;
    } else {
      first = item;
    }
    last = item;
    xyz += 3 * count;
    points -= count;
  }
  if (old != NULL) rk_kill_drawing(s, old);
  while (first != NULL) {
    item = first->next_queued;
    rk_link_item(s, first, NULL);
    rk_queue(s, first);
    first = item;
  }
  return RK_OK;
}

static inline int rk_say_points(rk_source *s, int form, const char *id, uint32_t rgba,
                                double size_px, rk_path carrier, const double *xyz, size_t points) {
  char key[RK_ENCODED_BYTES], text[RK_KEY_BYTES];
  const char *end = rk_put_name(key, id), *text_end = rk_put_carrier_path(text, carrier);
  const size_t key_size = end == NULL ? 0 : (size_t)(end - key);
  rk_draft draft = rk_draft_of(form);
  rk_item *old;
  size_t fixed, at, count;
  uint32_t parts = 0;
  if (end == NULL || text_end == NULL) return RK_BAD_NAME;
  if (xyz == NULL || points == 0 || !(size_px >= 1e-9)) return RK_BAD_ARGUMENT;
  if (points > SIZE_MAX / (3 * sizeof(double))) return RK_TOO_LONG;
  if (!rk_is_number(size_px)) return RK_BAD_NUMBER;
  for (at = 0; at < 3 * points; ++at) {
    if (!rk_is_number(xyz[at])) return RK_BAD_NUMBER;
  }
  draft.rgba = rgba;
  draft.text = text;
  draft.text_size = draft.carrier_size = (size_t)(text_end - text);
  fixed = rk_line_bound(key_size, draft.text_size, 1);
  for (at = 0; at < points; at += count) {
    count = rk_points_of_part(s, fixed, xyz + 3 * at, points - at);
    if (count == 0 || ++parts > RK_VALUES_MOST) return RK_TOO_LONG;
  }
  old = rk_find(s, RK_DRAWING, 1, key, key_size);
  if (old == NULL || parts > 1 || old->part_count != 1 || old->form != form) {
    int same = old != NULL && old->form == form && old->part_count == parts;
    const rk_item *item = old;
    for (at = 0; same && at < points; at += count, item = item->after) {
      count = rk_points_of_part(s, fixed, xyz + 3 * at, points - at);
      rk_draft_part(s, &draft, size_px, xyz + 3 * at, count);
      same = rk_is_same(item, &draft);
    }
    if (same) return RK_OK;
    return rk_replace_drawing(s, key, key_size, &draft, size_px, xyz, points, parts, fixed);
  }
  rk_draft_part(s, &draft, size_px, xyz, points);
  return rk_say(s, old, &draft);
}

RK_SOURCE_API int rk_source_line(rk_source *source, const char *id, uint32_t rgba, double size_px,
                                 rk_path carrier, const double *xyz, size_t points) {
  return rk_say_points(source, RK_LINE, id, rgba, size_px, carrier, xyz, points);
}

RK_SOURCE_API int rk_source_points(rk_source *source, const char *id, uint32_t rgba, double size_px,
                                   rk_path carrier, const double *xyz, size_t points) {
  return rk_say_points(source, RK_POINTS, id, rgba, size_px, carrier, xyz, points);
}

RK_SOURCE_API int rk_source_label(rk_source *source, const char *id, rk_path carrier,
                                  const double xyz[3], const char *text) {
  char key[RK_ENCODED_BYTES];
  char *const begin = source->buffer, *const limit = begin + source->line_most;
  char *end = rk_put_name(key, id), *carried;
  const size_t key_size = end == NULL ? 0 : (size_t)(end - key);
  rk_draft draft = rk_draft_of(RK_LABEL);
  rk_item *old;
  char place[RK_KEY_BYTES];
  const char *place_end = rk_put_carrier_path(place, carrier);
  if (end == NULL || place_end == NULL) return RK_BAD_NAME;
  if (xyz == NULL) return RK_BAD_ARGUMENT;
  if (place_end - place > limit - begin) return RK_TOO_LONG;
  carried = rk_put_bytes(begin, place, (size_t)(place_end - place));
  end = rk_put_string(carried, limit, text);
  if (end == NULL) {
    /* Too long for a datagram, or no text at all. */
    return text != NULL && strlen(text) <= RK_STRING_BYTES && strlen(text) > source->line_most / 2
               ? RK_TOO_LONG
               : RK_BAD_TEXT;
  }
  draft.values = xyz;
  draft.value_count = 3;
  draft.text = begin;
  draft.text_size = (size_t)(end - begin);
  draft.carrier_size = (size_t)(carried - begin);
  old = rk_find(source, RK_DRAWING, 1, key, key_size);
  if (old != NULL && old->form == RK_LABEL) return rk_say(source, old, &draft);
  {
    const int result = rk_say_new(source, RK_DRAWING, key, key_size, NULL, NULL, &draft, NULL);
    if (result == RK_OK && old != NULL) rk_kill_drawing(source, old);
    return result;
  }
}

RK_SOURCE_API int rk_source_erase(rk_source *source, const char *id) {
  char key[RK_ENCODED_BYTES] = "*";
  const char *end = id == NULL ? key + 1 : rk_put_name(key, id);
  const rk_draft draft = rk_draft_of(RK_NOTHING);
  rk_item *item, *next;
  int result;
  if (end == NULL) return RK_BAD_NAME;
  result = rk_say_once(source, RK_ERASURE, key, (size_t)(end - key), &draft);
  if (result != RK_OK) return result;
  if (id != NULL) {
    item = rk_find(source, RK_DRAWING, 1, key, (size_t)(end - key));
    if (item != NULL) rk_kill_drawing(source, item);
    return RK_OK;
  }
  for (item = source->first; item != NULL; item = next) {
    next = item->after;
    if (item->kind == RK_DRAWING) rk_kill(source, item);
  }
  return RK_OK;
}

RK_SOURCE_API int rk_source_view(rk_source *source, const char *name, const rk_view *view,
                                 rk_path carrier) {
  char key[RK_ENCODED_BYTES], text[RK_KEY_BYTES];
  const char *end = rk_put_name(key, name), *text_end = rk_put_carrier_path(text, carrier);
  rk_draft draft = rk_draft_of(RK_NOTHING);
  rk_item *item;
  double values[11];
  int i, is_apart = 0, has_up = 0;
  if (end == NULL || text_end == NULL) return RK_BAD_NAME;
  if (view == NULL) return RK_BAD_ARGUMENT;
  for (i = 0; i < 3; ++i) {
    const double distance = view->eye[i] - view->target[i];
    values[i] = view->eye[i];
    values[3 + i] = view->target[i];
    values[7 + i] = view->up[i];
    /* What differs and what is not 0 must still be so with nine decimals. */
    is_apart |= distance >= 2e-9 || distance <= -2e-9;
    has_up |= view->up[i] >= 1e-9 || view->up[i] <= -1e-9;
  }
  values[6] = view->fov_deg;
  values[10] = view->ortho_height_m;
  for (i = 0; i < 11; ++i) {
    if (!rk_is_number(values[i])) return RK_BAD_NUMBER;
  }
  if (!is_apart || !has_up || view->fov_deg < 1e-9 || view->fov_deg > 180 - 1e-9 ||
      (view->ortho_height_m != 0 && view->ortho_height_m < 1e-9)) {
    return RK_BAD_ARGUMENT;
  }
  draft.values = values;
  draft.value_count = 11;
  draft.text = text;
  draft.text_size = draft.carrier_size = (size_t)(text_end - text);
  item = rk_find(source, RK_VIEW, 1, key, (size_t)(end - key));
  if (item != NULL) return rk_say(source, item, &draft);
  return rk_say_new(source, RK_VIEW, key, (size_t)(end - key), NULL, NULL, &draft, NULL);
}

RK_SOURCE_API int rk_source_event(rk_source *source, const char *text) {
  rk_draft draft = rk_draft_of(RK_NOTHING);
  const int result = rk_draft_string(source, &draft, text);
  return result == RK_OK ? rk_say_once(source, RK_EVENT, "", 0, &draft) : result;
}

/* ---- Sending ---- */

/* Begins a datagram; `part`: 0, or the part of the restatement that it is. */
static inline char *rk_put_header(const rk_source *s, char *at, uint32_t part) {
  at = rk_put_bytes(at, s->prefix, s->prefix_bytes);
  at = rk_put_unsigned(at, s->sequence);
  *at++ = ' ';
  at = rk_put_bytes(at, s->time_text, s->time_bytes);
  if (part != 0) {
    at = rk_put_word(at, " restated");
    if (s->parts <= RK_PARTS_MOST) {
      at = rk_put_unsigned(rk_put_word(at, " part=r"), s->round);
      *at++ = ':';
      at = rk_put_unsigned(at, part);
      *at++ = '/';
      at = rk_put_unsigned(at, s->parts);
    }
  }
  *at++ = '\n';
  return at;
}

static inline void rk_send_datagram(rk_source *s) {
  s->is_open = 0;
  ++s->sequence;
  if (s->config.send(s->config.context, s->buffer, s->used) != 0) s->has_failed = 1;
}

/* The line at s->used, `bytes` long, becomes part of the datagram, or of the next one. */
static inline void rk_keep_line(rk_source *s, size_t bytes) {
  if (s->used + bytes > s->config.max_datagram) {
    char *const line = s->buffer + s->used;
    char header[2 * RK_ENCODED_BYTES + 8 + RK_HEADER_BYTES];
    rk_send_datagram(s);
    s->used = (size_t)(rk_put_header(s, header, 0) - header);
    memmove(s->buffer + s->used, line, bytes);
    memcpy(s->buffer, header, s->used);
    s->is_open = 1;
  }
  s->used += bytes;
}

static inline void rk_send_change(rk_source *s, rk_item *item) {
  char *begin;
  if (!s->is_open) {
    s->used = (size_t)(rk_put_header(s, s->buffer, 0) - s->buffer);
    s->is_open = 1;
  }
  begin = s->buffer + s->used;
  item->line_bytes = (uint32_t)(rk_put_line(begin, item) - begin);
  rk_keep_line(s, item->line_bytes);
}

/* Joints mean nothing before the order that they follow, or that is cancelled for them. It is said
 * again before the first joints of each restatement round: a receiver that joined with it has not
 * heard the order, and would keep what it read until the round after. */
static inline void rk_send_order(rk_source *s, rk_slot *slot) {
  if (slot->order_round == s->round + 1) return;
  slot->order_round = s->round + 1;
  rk_send_change(s, slot->order);
}

/* The unit once a restatement round. */
static inline void rk_send_signal(rk_source *s, rk_item *item) {
  if (item->form != RK_NUMBER) {
    rk_send_change(s, item);
    return;
  }
  item->part_count = item->rgba != s->round + 1 ? RK_WHOLE : 1;
  item->rgba = s->round + 1;
  item->values[1] = item->values[0];
  rk_send_change(s, item);
  /* A restatement has it. */
  if (item->part_count != RK_WHOLE) item->line_bytes += item->text_size + 1;
}

static inline void rk_send_item(rk_source *s, rk_item *item) {
  if (item->kind == RK_DEVICE && item->was_removed) {
    const uint8_t form = item->form;
    item->was_removed = 0;
    item->form = RK_REMOVED;
    if (form == RK_ADDED) {
      const uint32_t text_size = item->text_size;
      item->text_size = 0;
      rk_send_change(s, item);
      item->text_size = text_size;
      item->form = form;
    }
  }
  if (item->kind == RK_ORDER) {
    rk_send_order(s, item->slot);
  } else if (item->kind == RK_SIGNAL) {
    rk_send_signal(s, item);
  } else {
    if (item->kind == RK_JOINTS) rk_send_order(s, item->slot);
    rk_send_change(s, item);
  }
}

static inline void rk_send_changes(rk_source *s) {
  while (s->queue_first != NULL) {
    rk_item *const item = s->queue_first;
    const int is_gone = item->is_dead || item->kind == RK_EVENT || item->kind == RK_ERASURE ||
                        item->kind == RK_CANCELLATION;
    s->queue_first = item->next_queued;
    item->is_queued = 0;
    /* A device forgotten after it was removed is removed first. */
    if (item->is_dead && item->was_removed) {
      item->form = RK_REMOVED;
      item->text_size = 0;
    }
    if (!item->is_dead || item->was_removed) rk_send_item(s, item);
    if (is_gone) rk_free_item(s, item);
  }
  s->queue_last = NULL;
  if (s->is_open) rk_send_datagram(s);
}

/* Begins a restatement: shares the items out into parts. Values may grow until their part is sent,
 * so an eighth is left free; where that was not enough, the longest possible lines are assumed. */
static inline void rk_plan_round(rk_source *s, int64_t now) {
  const size_t room = s->is_careful ? s->line_most : s->line_most - s->line_most / 8;
  size_t used = 0;
  rk_item *item;
  s->parts = 1;
  for (item = s->first; item != NULL; item = item->after) {
    size_t bytes = item->line_bytes;
    if (s->is_careful) bytes = rk_line_bound(item->key_size, item->text_size, item->value_count);
    if (used > 0 && used + bytes > room) {
      ++s->parts;
      used = 0;
    }
    item->part = s->parts;
    used += bytes;
  }
  ++s->round;
  s->parts_sent = 0;
  s->cursor = s->first;
  s->round_began = now;
  s->is_restating = 1;
}

/* Sends the next part with the values of now; 0 when they do not fit. */
static inline int rk_send_part(rk_source *s) {
  const uint32_t part = s->parts_sent + 1;
  rk_item *item = s->cursor;
  s->used = (size_t)(rk_put_header(s, s->buffer, part) - s->buffer);
  for (; item != NULL && item->part <= part; item = item->after) {
    char *const begin = s->buffer + s->used;
    if (item->part == 0) continue; /* newer than the restatement */
    if (item->kind == RK_SIGNAL && item->form == RK_NUMBER) {
      item->part_count = RK_WHOLE;
      item->rgba = s->round + 1;
      item->values[1] = item->values[0];
    }
    item->line_bytes = (uint32_t)(rk_put_line(begin, item) - begin);
    s->used += item->line_bytes;
    if (s->used > s->config.max_datagram) return 0;
    if (item->kind == RK_ORDER) item->slot->order_round = s->round + 1;
  }
  s->cursor = item;
  ++s->parts_sent;
  rk_send_datagram(s);
  if (s->parts_sent == s->parts) s->is_restating = 0;
  return 1;
}

/* At most half of what a clock can say. */
static inline int64_t rk_elapsed(int64_t now, int64_t then) {
  const uint64_t passed = (uint64_t)now - (uint64_t)then;
  if (now <= then) return 0;
  return passed < (uint64_t)INT64_MAX / 2 ? (int64_t)passed : INT64_MAX / 2;
}

static inline int64_t rk_after(int64_t moment, int64_t by) {
  return moment > INT64_MAX - by ? rk_never : moment + by;
}

static inline int64_t rk_round_spread(const rk_source *s) {
  return s->config.restate_ns < rk_spread_ns ? s->config.restate_ns : rk_spread_ns;
}

/* How many parts are due: evenly over the spread, and those ahead that would come too late if the
 * next flush is as far off as the last one is. */
static inline uint32_t rk_parts_due(const rk_source *s, int64_t now, int64_t step) {
  const int64_t spread = rk_round_spread(s);
  const int64_t passed = rk_elapsed(now, s->round_began);
  uint64_t due;
  if (passed >= spread || step >= spread - passed) return s->parts;
  due = (uint64_t)s->parts * (uint64_t)(passed + step) / (uint64_t)spread + 1;
  return due < s->parts ? (uint32_t)due : s->parts;
}

static inline void rk_send_restatement(rk_source *s, int64_t now) {
  const int64_t restate = s->config.restate_ns;
  int64_t step = 0;
  uint32_t due;
  if (!s->has_flushed || now < s->last_flush) {
    /* The first time, or the clock went back. */
    s->has_flushed = 1;
    s->next_round = rk_after(now, restate);
    s->is_restating = 0;
  } else {
    step = rk_elapsed(now, s->last_flush);
  }
  s->last_flush = now;
  if (s->is_restating && rk_elapsed(now, s->round_began) >= rk_expiry_ns) rk_plan_round(s, now);
  if (!s->is_restating && now >= s->next_round && s->sequence > 0) {
    rk_plan_round(s, now);
    s->next_round = rk_after(s->next_round, restate);
    if (s->next_round <= now) s->next_round = rk_after(now, restate);
  }
  if (!s->is_restating) return;
  due = rk_parts_due(s, now, step);
  while (s->is_restating && s->parts_sent < due) {
    if (!rk_send_part(s)) {
      s->is_careful = 1;
      rk_plan_round(s, now);
      due = rk_parts_due(s, now, step);
    }
  }
}

RK_SOURCE_API int rk_source_flush_at(rk_source *source, int64_t now_ns, int64_t time_ns) {
  char *end = source->time_text;
  if (time_ns < 0) {
    *end++ = '-';
  } else {
    end = rk_put_unsigned(end, (uint64_t)time_ns / 1000000000u);
    end = rk_put_decimals(end, (uint32_t)((uint64_t)time_ns % 1000000000u));
  }
  source->time_bytes = (size_t)(end - source->time_text);
  source->has_failed = 0;
  rk_send_changes(source);
  if (source->config.restate_ns > 0) rk_send_restatement(source, now_ns);
  return source->has_failed ? RK_NOT_SENT : RK_OK;
}

RK_SOURCE_API int rk_source_flush(rk_source *source, int64_t now_ns) {
  return rk_source_flush_at(source, now_ns, now_ns);
}

RK_SOURCE_API int64_t rk_source_due(const rk_source *source) {
  if (source->config.restate_ns == 0 || !source->has_flushed) return rk_never;
  if (!source->is_restating) return source->next_round;
  {
    const uint64_t spread = (uint64_t)rk_round_spread(source);
    const uint64_t passed = (source->parts_sent * spread + source->parts - 1) / source->parts;
    return rk_after(source->round_began, (int64_t)passed);
  }
}

RK_SOURCE_API uint64_t rk_source_sent(const rk_source *source) { return source->sequence; }

#ifdef __cplusplus
}
#endif
#endif /* RK_SOURCE_IMPLEMENTATION */
