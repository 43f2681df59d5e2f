// The example of schedulers/README.md: workers take chunks from both ends of the items, the even ones from
// the front, the odd ones from the back.
#include "tests/schedulers/example_scheduler.h"

#include <mutex>

#include "schedulers/thread_pool.h"
#include "schedulers/work.h"

namespace raysweep {

namespace {

class BothEnds final : public Scheduler {
 public:
  explicit BothEnds(const SchedulerOptions& options) : pool_(options) {}

 private:
  void run_items(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t size = chunk.size(items, pool_.threads());
    size_t front = 0, back = items.count;  // what nobody has taken yet
    std::mutex mutex;
    pool_.run([&](int worker) {
      for (;;) {
        size_t begin = 0, end = 0;
        {
          const std::scoped_lock lock(mutex);
          const size_t taken = std::min(size, back - front);
          if (worker % 2 == 0) {
            begin = front, end = front += taken;
          } else {
            end = back, begin = back -= taken;
          }
        }
        if (begin == end) return;
        work(begin, end, worker);
      }
    });
  }

  ThreadPool pool_;
};

}  // namespace

std::unique_ptr<Scheduler> make_both_ends(const SchedulerOptions& options) {
  return std::make_unique<BothEnds>(options);
}

}  // namespace raysweep
