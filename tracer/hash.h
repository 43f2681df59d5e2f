// Fingerprints: XXH3, 128 bits, as 32 hexadecimal digits.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

struct XXH3_state_s;

namespace raysweep {

/// Of everything that was added, in that order.
class Hash {
 public:
  Hash();

  void add_bytes(const void* bytes, size_t count);
  /// Types with padding must be added by their members: what lies between them is chance.
  template <class T>
  requires std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>
  void add(const T& value) { add_bytes(&value, sizeof value); }
  /// A text and where it ends.
  void add(std::string_view text);

  [[nodiscard]] std::string text() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

/// Of the bytes alone.
[[nodiscard]] std::string hash_of(const void* bytes, size_t count);
[[nodiscard]] std::string hash_of(std::string_view text);

}  // namespace raysweep
