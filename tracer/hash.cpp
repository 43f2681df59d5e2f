#include "tracer/hash.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <new>

namespace raysweep {

namespace {

std::string to_text(const XXH128_hash_t& hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

Hash::Hash() : state_(XXH3_createState()) {
  if (!state_) throw std::bad_alloc();
  XXH3_128bits_reset(state_.get());
}

void Hash::Free::operator()(XXH3_state_s* state) const { XXH3_freeState(state); }

void Hash::add_bytes(const void* bytes, size_t count) { XXH3_128bits_update(state_.get(), bytes, count); }

void Hash::add(std::string_view text) {
  add(text.size());
  add_bytes(text.data(), text.size());
}

std::string Hash::text() const { return to_text(XXH3_128bits_digest(state_.get())); }

std::string hash_of(const void* bytes, size_t count) { return to_text(XXH3_128bits(bytes, count)); }

std::string hash_of(std::string_view text) { return hash_of(text.data(), text.size()); }

}  // namespace raysweep
