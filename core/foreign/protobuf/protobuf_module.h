#pragma once

#include <stddef.h>
#include <stdint.h>

// The C interface of librocinante_protobuf_messages.so: the module is loaded with dlopen and shares
// no C++ with the program. Functions are found by the names of their typedefs' comments. A schema
// is used by any number of threads, a reader by one.

#define ROCINANTE_PROTOBUF_ABI 1

extern "C" {

/// rocinante_protobuf_abi: ROCINANTE_PROTOBUF_ABI of the module's build; others are not used.
typedef int (*RocinanteProtobufAbi)(void);

struct RocinanteProtobufSchema;
struct RocinanteProtobufReader;

/// rocinante_protobuf_open: the message type `message` of a FileDescriptorSet. Null, with one
/// sentence in `error`, when there is none or the bytes are not sound.
typedef struct RocinanteProtobufSchema* (*RocinanteProtobufOpen)(const void* set, size_t bytes,
                                                                 const char* message, char* error,
                                                                 size_t error_bytes);
/// rocinante_protobuf_close: null is allowed. The schema's readers are closed before.
typedef void (*RocinanteProtobufClose)(struct RocinanteProtobufSchema* schema);

/// rocinante_protobuf_find: whether `path` ("a.b[2].c") leads to one value. 1, or 0 with one
/// sentence in `error`.
typedef int32_t (*RocinanteProtobufFind)(const struct RocinanteProtobufSchema* schema,
                                         const char* path, char* error, size_t error_bytes);

/// rocinante_protobuf_read_of: a reader of `count` paths, each of which rocinante_protobuf_find
/// found; null when one is not. The schema outlives it.
typedef struct RocinanteProtobufReader* (*RocinanteProtobufReadOf)(
    const struct RocinanteProtobufSchema* schema, const char* const* paths, size_t count);
/// rocinante_protobuf_end: null is allowed.
typedef void (*RocinanteProtobufEnd)(struct RocinanteProtobufReader* reader);

struct RocinanteProtobufValue {
  int32_t kind;      ///< 0 missing, 1 number, 2 text
  double number;     ///< any, NaN too
  const char* text;  ///< the reader's, until its next message
  size_t text_bytes;
};

/// rocinante_protobuf_read: reads a message and fills one value for each path. Null, or the reason
/// why the bytes are not such a message; the reason lives as long as the module.
typedef const char* (*RocinanteProtobufRead)(struct RocinanteProtobufReader* reader,
                                             const void* message, size_t bytes,
                                             struct RocinanteProtobufValue* values);

/// What rocinante_protobuf_list calls for a value: its path and, in words, itself. 0: no more.
typedef int32_t (*RocinanteProtobufFound)(void* to, const char* path, size_t path_bytes,
                                          const char* value, size_t value_bytes);
/// rocinante_protobuf_list: reads a message and names every value in it, also those of fields that
/// the schema does not know ("a.#7"), until `found` answers 0. Nothing for other bytes.
typedef void (*RocinanteProtobufList)(struct RocinanteProtobufReader* reader, const void* message,
                                      size_t bytes, RocinanteProtobufFound found, void* to);

}  // extern "C"
