#include "tracer/accel/build.h"

namespace raysweep {

namespace {

template <class T>
size_t split_in_the_middle(const SplitRequest<T>& node) {
  if (node.order.size() <= static_cast<size_t>(node.leaf_size)) return 0;
  for (const Box<T>* halved : {&node.box, &node.centres}) {
    const int axis = halved->longest_axis();
    const size_t left = partition_at(node, axis, halved->centre()[axis]);
    if (left > 0 && left < node.order.size()) return left;
  }
  // The centres differ by so little that their middle rounds to the lower one.
  return partition_evenly(node);
}

}  // namespace

template <class T>
Hierarchy<T> build_median(std::span<const Box<T>> items, int leaf_size) {
  return build_hierarchy(items, leaf_size, split_in_the_middle<T>);
}

template Hierarchy<float> build_median(std::span<const Box<float>>, int);
template Hierarchy<double> build_median(std::span<const Box<double>>, int);

}  // namespace raysweep
