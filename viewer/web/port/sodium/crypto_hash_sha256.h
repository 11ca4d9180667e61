#pragma once

// Declared for core/base/hash.cpp. A page never hashes a session: nothing that it links calls
// these, and nothing defines them.

struct crypto_hash_sha256_state {
  unsigned char unused;
};

extern "C" {
int crypto_hash_sha256_init(crypto_hash_sha256_state* state);
int crypto_hash_sha256_update(crypto_hash_sha256_state* state, const unsigned char* bytes,
                              unsigned long long size);
int crypto_hash_sha256_final(crypto_hash_sha256_state* state, unsigned char* digest);
}
