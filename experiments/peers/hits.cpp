#include "experiments/peers/hits.h"

#include <algorithm>
#include <cmath>

namespace raysweep {

HitDifferences differences(const HitBatch& a, const HitBatch& b, size_t size, bool any_hit) {
  HitDifferences found;
  for (size_t i = 0; i < size; ++i) {
    const bool hit_a = a.id[i] != no_hit_id, hit_b = b.id[i] != no_hit_id;
    if (any_hit ? hit_a == hit_b : a.id[i] == b.id[i]) continue;
    found.rays++;
    if (hit_a && hit_b && std::abs(a.t[i] - b.t[i]) <= same_place_share * std::max(a.t[i], b.t[i]))
      found.same_place++;
  }
  return found;
}

}  // namespace raysweep
