// Rays of one sample that wait to be traced.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tracer/math/ray.h"
#include "tracer/shade/medium_set.h"

namespace raysweep {

/// A ray on its way, and what it still needs to know of the path that led to it.
template <class T>
struct PendingRay {
  Ray<T> ray;
  Vec3<T> weight;  // what its radiance is multiplied by on the way to the eye
  int level;       // of the hit that it may make; primary rays make hits of level 1
  bool refracted;
  MediumSet media;
};

/// The heaviest ray comes first, of equals the one that was added first: what remains at any moment is what
/// matters least, and the order depends on nothing but the sample. Storage is kept from sample to sample.
template <class T>
class PendingRays {
 public:
  void add(const PendingRay<T>& ray) {
    uint32_t slot = static_cast<uint32_t>(rays_.size());
    if (free_.empty()) {
      rays_.push_back(ray);
    } else {
      slot = free_.back();
      free_.pop_back();
      rays_[slot] = ray;
    }
    order_.push_back({max_abs(ray.weight), added_++, slot});
    std::push_heap(order_.begin(), order_.end());
  }

  [[nodiscard]] PendingRay<T> take() {
    std::pop_heap(order_.begin(), order_.end());
    const uint32_t slot = order_.back().slot;
    order_.pop_back();
    free_.push_back(slot);
    return rays_[slot];
  }

  template <class Visit>
  void for_each(Visit&& visit) const {
    for (const Place& place : order_) visit(rays_[place.slot]);
  }

  [[nodiscard]] bool empty() const { return order_.empty(); }
  [[nodiscard]] size_t size() const { return order_.size(); }

  void clear() {
    rays_.clear();
    order_.clear();
    free_.clear();
    added_ = 0;
  }

 private:
  struct Place {
    T weight;
    uint64_t number;
    uint32_t slot;
    bool operator<(const Place& other) const {
      return weight < other.weight || (weight == other.weight && number > other.number);
    }
  };

  std::vector<PendingRay<T>> rays_;
  std::vector<Place> order_;
  std::vector<uint32_t> free_;
  uint64_t added_ = 0;
};

}  // namespace raysweep
