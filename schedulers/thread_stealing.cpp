#include <random>

#include "schedulers/builtin.h"
#include "schedulers/thread_pool.h"
#include "schedulers/work.h"

namespace raysweep {

namespace {

/// A worker's deque of successive items. Its owner takes chunks from the front, thieves take half of what is
/// left from the back. Begin and end are one atomic word, so that both sides agree by compare-and-swap alone.
/// Items never return to a deque that they left unexecuted but as the same range, so a word that came back
/// means the same as before (no ABA problem).
class alignas(128) RangeDeque {
 public:
  struct Range {
    uint32_t begin = 0, end = 0;
    [[nodiscard]] bool empty() const { return begin >= end; }
  };

  /// Relaxed here and below: the words carry no data but themselves; the pool orders everything else.
  void put(Range r) { word_.store(pack(r), std::memory_order_relaxed); }

  Range take_front(uint32_t count) {
    return take(
        [=](Range r) {
          return Range{std::min(r.end, r.begin + std::min(count, r.end - r.begin)), r.end};
        },
        [](Range had, Range kept) {
          return Range{had.begin, kept.begin};
        });
  }
  /// Half, rounded up, of what is left; but all of it where that is not more than `least`.
  Range take_back(uint32_t least) {
    return take(
        [=](Range r) {
          const uint32_t left = r.end - r.begin;
          return left <= least ? Range{r.begin, r.begin} : Range{r.begin, r.begin + left / 2};
        },
        [](Range had, Range kept) {
          return Range{kept.end, had.end};
        });
  }

  // Items that the owner has begun, for others to see when all are. Written by the owner alone.
  std::atomic<size_t> begun{0};

 private:
  template <class Keep, class Taken>
  Range take(Keep keep, Taken taken) {
    uint64_t word = word_.load(std::memory_order_relaxed);
    for (;;) {
      const Range had = unpack(word);
      if (had.empty()) return {};
      const Range kept = keep(had);
      if (word_.compare_exchange_weak(word, pack(kept), std::memory_order_relaxed)) return taken(had, kept);
    }
  }
  static uint64_t pack(Range r) { return uint64_t{r.begin} << 32 | r.end; }
  static Range unpack(uint64_t word) {
    return {static_cast<uint32_t>(word >> 32), static_cast<uint32_t>(word)};
  }

  std::atomic<uint64_t> word_{0};
};

/// Every worker begins with one block, and steals from random others when its own is done.
class ThreadStealing final : public Scheduler {
 public:
  explicit ThreadStealing(const SchedulerOptions& options)
      : pool_(options), deques_(static_cast<size_t>(options.threads)) {
    for (int worker = 0; worker < options.threads; ++worker)
      random_.push_back({std::minstd_rand(static_cast<unsigned>(worker) + 1)});
  }

 private:
  void run_items(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t parts = deques_.size();
    for (size_t part = 0; part < parts; ++part) {
      deques_[part].put({static_cast<uint32_t>(block_begin(items.count, part, parts)),
                         static_cast<uint32_t>(block_begin(items.count, part + 1, parts))});
      deques_[part].begun.store(0, std::memory_order_relaxed);
    }
    const auto least = static_cast<uint32_t>(std::min(chunk.size(items, pool_.threads()), items.count));
    pool_.run([&](int worker) {
      do run_own(least, worker, work);
      while (steal(least, worker, items.count));
    });
  }

  void run_own(uint32_t least, int worker, const Work& work) {
    RangeDeque& own = deques_[static_cast<size_t>(worker)];
    for (RangeDeque::Range r; !(r = own.take_front(least)).empty();) {
      own.begun.fetch_add(r.end - r.begin, std::memory_order_relaxed);
      work(r.begin, r.end, worker);
    }
  }

  /// Fills the worker's own deque; false once every item has been begun. A deque may look empty while its
  /// items are on their way to a thief, so empty deques alone do not mean that there is nothing left.
  bool steal(uint32_t least, int worker, size_t count) {
    const auto self = static_cast<size_t>(worker);
    std::minstd_rand& random = random_[self].next;
    for (;;) {
      const size_t first = random() % deques_.size();
      for (size_t i = 0; i < deques_.size(); ++i) {
        const size_t victim = (first + i) % deques_.size();
        if (victim == self) continue;
        const RangeDeque::Range stolen = deques_[victim].take_back(least);
        if (stolen.empty()) continue;
        deques_[self].put(stolen);
        return true;
      }
      size_t begun = 0;
      for (const RangeDeque& deque : deques_) begun += deque.begun.load(std::memory_order_relaxed);
      if (begun == count) return false;
      std::this_thread::yield();
    }
  }

  ThreadPool pool_;
  std::vector<RangeDeque> deques_;
  struct alignas(128) Random {
    std::minstd_rand next;
  };
  std::vector<Random> random_;  // one a worker
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_stealing(const SchedulerOptions& options) {
  return std::make_unique<ThreadStealing>(options);
}

}  // namespace raysweep
