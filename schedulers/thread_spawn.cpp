#include <thread>
#include <vector>

#include "schedulers/builtin.h"

namespace raysweep {

namespace {

/// Threads created anew for every run, one contiguous block each, while the caller waits (the 2022 course
/// work). The only scheduler whose thread creation is timed.
class ThreadSpawn final : public Scheduler {
 public:
  explicit ThreadSpawn(int threads) : threads_(static_cast<size_t>(threads)) {}

 private:
  void run_items(const ItemSpace& items, const Chunk&, const Body& body) override {
    std::vector<std::jthread> workers;  // joined on the way out, also when a thread cannot be made
    for (size_t part = 0; part < threads_; ++part) {
      const size_t begin = block_begin(items.count, part, threads_),
                   end = block_begin(items.count, part + 1, threads_);
      if (begin < end)
        workers.emplace_back([&body, begin, end, part] { body(begin, end, static_cast<int>(part)); });
    }
  }

  size_t threads_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_spawn(int threads) { return std::make_unique<ThreadSpawn>(threads); }

}  // namespace raysweep
