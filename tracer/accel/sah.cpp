#include <algorithm>

#include "tracer/accel/parts.h"

namespace raysweep {

namespace {

/// References are looked at in pieces of so many that handing out is cheap, of so few that they stay in the
/// nearest caches, and that even a small scene makes some.
constexpr uint32_t chunk_size_of(size_t count) {
  return std::clamp<uint32_t>(static_cast<uint32_t>(count / 8), 1024, 4096);
}

/// References of one part that one body works on, with what it finds.
template <class T>
struct Chunk {
  size_t part;  // its index in the level
  uint32_t begin, end;
  Bins<T> bins{};
  uint32_t left_begin = 0, right_begin = 0;
  LaneBox<T> left = LaneBox<T>::empty(), right = LaneBox<T>::empty();  // of centres
};

/// One part of the top of the tree that is being split, together with all others of its depth.
template <class T>
struct Cut {
  Part<T> part, left = Part<T>::of(0, 0, 0, 0), right = left;
  BinMapping<T> mapping;
  Bins<T> bins{most_bins};
  std::optional<SplitPlane<T>> plane;

  explicit Cut(const Part<T>& whole) : part(whole), mapping(Parts<T>::mapping(whole)) {}
  [[nodiscard]] bool is_split() const { return plane && plane->cost < Box<T>::inf; }
};

template <class T>
class Builder {
 public:
  Builder(std::span<const Box<T>> items, int leaf_size, int block, const ForEach& for_each)
      : items_(items),
        for_each_(for_each),
        chunk_size_(chunk_size_of(items.size())),
        parts_(items.size(), leaf_size, block) {
    tree_.order.resize(items.size());
    tree_.nodes.emplace_back();
  }

  [[nodiscard]] Hierarchy<T> run() {
    constexpr size_t enough_subtrees = 64;
    const auto subtree_size =
        std::max<uint32_t>(chunk_size_, static_cast<uint32_t>(items_.size() / enough_subtrees));
    std::vector<Part<T>> level{root()};
    while (!level.empty()) {
      std::vector<Cut<T>> cuts;
      for (const Part<T>& part : level) {
        if (part.count() > subtree_size && parts_.takes_a_plane(part)) {
          cuts.emplace_back(part);
        } else {
          subtrees_.push_back(part);
        }
      }
      level = split_all(cuts);
    }
    build_subtrees();
    return std::move(tree_);
  }

 private:
  [[nodiscard]] Part<T> root() {
    const auto count = static_cast<uint32_t>(items_.size());
    Part<T> root = Part<T>::of(0, count, 0, 0);
    std::vector<Part<T>> pieces;
    for (uint32_t begin = 0; begin < count; begin += chunk_size_)
      pieces.push_back(Part<T>::of(begin, std::min(count, begin + chunk_size_), 0, 0));
    for_each_(pieces.size(), [&](size_t i) {
      Part<T>& piece = pieces[i];
      const auto references = parts_.references(piece);
      for (uint32_t k = 0; k < piece.count(); ++k) {
        references[k].set(items_[piece.begin + k], piece.begin + k);
        piece.box.include(references[k].lower, references[k].upper);
      }
      piece.centres = bounds_of_centres<T>(references);
    });
    for (const Part<T>& piece : pieces) {
      root.box.include(piece.box);
      root.centres.include(piece.centres);
    }
    return root;
  }

  /// The parts of the next level. Those that no plane splits become subtrees, which know what to do.
  [[nodiscard]] std::vector<Part<T>> split_all(std::vector<Cut<T>>& cuts) {
    std::vector<Chunk<T>> chunks;
    for (size_t i = 0; i < cuts.size(); ++i) {
      const Part<T>& part = cuts[i].part;
      for (uint32_t begin = part.begin; begin < part.end; begin += chunk_size_)
        chunks.push_back({i, begin, std::min(part.end, begin + chunk_size_)});
    }
    for_each_(chunks.size(), [&](size_t i) {
      Chunk<T>& chunk = chunks[i];
      chunk.bins = Bins<T>(most_bins);
      parts_.steps().fill(chunk.bins, references(chunk, cuts), cuts[chunk.part].mapping);
    });
    for (const Chunk<T>& chunk : chunks) cuts[chunk.part].bins.add(chunk.bins, most_bins);
    for (Cut<T>& cut : cuts) choose_plane(cut);
    place(chunks, cuts);
    for_each_(chunks.size(), [&](size_t i) { move(chunks[i], cuts); });
    for (const Chunk<T>& chunk : chunks) {
      cuts[chunk.part].left.centres.include(chunk.left);
      cuts[chunk.part].right.centres.include(chunk.right);
    }
    std::vector<Part<T>> next;
    for (Cut<T>& cut : cuts) {
      if (cut.is_split()) add_children(cut.part, cut.left, cut.right, tree_.nodes, next);
    }
    return next;
  }

  [[nodiscard]] std::span<Reference<T>> references(const Chunk<T>& chunk, const std::vector<Cut<T>>& cuts) {
    const Part<T>& part = cuts[chunk.part].part;
    return parts_.references(part).subspan(chunk.begin - part.begin, chunk.end - chunk.begin);
  }

  void choose_plane(Cut<T>& cut) {
    cut.plane = parts_.plane(cut.part, cut.bins, cut.mapping.count);
    if (cut.is_split()) {
      parts_.divide(cut.part, *cut.plane, cut.left, cut.right);
    } else {
      subtrees_.push_back(cut.part);
    }
  }

  /// Where the references of each chunk go: behind those of the chunks before it.
  static void place(std::vector<Chunk<T>>& chunks, const std::vector<Cut<T>>& cuts) {
    uint32_t left = 0, right = 0;
    for (Chunk<T>& chunk : chunks) {
      const Cut<T>& cut = cuts[chunk.part];
      if (!cut.is_split()) continue;
      if (chunk.begin == cut.part.begin) left = right = 0;
      chunk.left_begin = left;
      chunk.right_begin = right;
      uint32_t here = 0;
      for (int b = 0; b < cut.plane->bin; ++b)
        here += static_cast<uint32_t>(chunk.bins.bin[b].count[cut.plane->axis]);
      left += here;
      right += chunk.end - chunk.begin - here;
    }
  }

  void move(Chunk<T>& chunk, const std::vector<Cut<T>>& cuts) {
    const Cut<T>& cut = cuts[chunk.part];
    if (!cut.is_split()) return;
    Reference<T>* const left = parts_.references(cut.left).data() + chunk.left_begin;
    Reference<T>* const right = parts_.references(cut.right).data() + chunk.right_begin;
    const auto moved = parts_.steps().move(references(chunk, cuts), cut.mapping, *cut.plane, left, right);
    chunk.left = moved.left;
    chunk.right = moved.right;
  }

  void build_subtrees() {
    std::vector<UnsetVector<Node<T>>> nodes(subtrees_.size());
    for_each_(nodes.size(), [&](size_t i) { nodes[i] = build_subtree(subtrees_[i]); });
    std::vector<uint32_t> first(nodes.size());
    size_t total = tree_.nodes.size();
    for (size_t i = 0; i < nodes.size(); ++i) {
      first[i] = static_cast<uint32_t>(total);
      total += nodes[i].size() - 1;
    }
    tree_.nodes.resize(total);
    for_each_(nodes.size(), [&](size_t i) {
      for (size_t k = 0; k < nodes[i].size(); ++k) {
        Node<T>& node = k == 0 ? tree_.nodes[subtrees_[i].node] : tree_.nodes[first[i] + k - 1];
        node = nodes[i][k];
        if (!node.is_leaf()) node.first += first[i] - 1;
      }
    });
  }

  /// Its nodes, numbered from 0, the root's number. The items' order goes where it belongs.
  [[nodiscard]] UnsetVector<Node<T>> build_subtree(const Part<T>& root) {
    UnsetVector<Node<T>> nodes;
    nodes.reserve(root.count());  // about half of it is needed; what is not touched costs nothing
    nodes.emplace_back();
    std::vector<Part<T>> pending{root};
    pending[0].node = 0;
    while (!pending.empty()) {
      const Part<T> part = pending.back();
      pending.pop_back();
      Part<T> left, right;
      if (parts_.split(part, left, right)) {
        add_children(part, left, right, nodes, pending);
        continue;
      }
      nodes[part.node] = {part.box.box(), part.begin, part.count()};
      const auto references = parts_.references(part);
      for (uint32_t i = 0; i < part.count(); ++i) tree_.order[part.begin + i] = references[i].item();
    }
    return nodes;
  }

  std::span<const Box<T>> items_;
  const ForEach& for_each_;
  const uint32_t chunk_size_;
  Parts<T> parts_;
  std::vector<Part<T>> subtrees_;
  Hierarchy<T> tree_;
};

}  // namespace

template <class T>
Hierarchy<T> build_sah(std::span<const Box<T>> items, int leaf_size, int block, const ForEach& for_each) {
  return items.empty() ? Hierarchy<T>{} : Builder<T>(items, leaf_size, block, for_each).run();
}

template Hierarchy<float> build_sah(std::span<const Box<float>>, int, int, const ForEach&);
template Hierarchy<double> build_sah(std::span<const Box<double>>, int, int, const ForEach&);

}  // namespace raysweep
