#include "schedulers/binding.h"
#include "schedulers/builtin.h"
#include "schedulers/work.h"

namespace raysweep {

namespace {

class Serial final : public Scheduler {
 public:
  explicit Serial(const SchedulerOptions& options) : caller_(Binding(options.processors), 0) {}

 private:
  void run_items(const ItemSpace& items, const Chunk&, const Work& work) override { work(0, items.count, 0); }

  BoundCaller caller_;
};

}  // namespace

std::unique_ptr<Scheduler> make_serial(const SchedulerOptions& options) {
  return std::make_unique<Serial>(options);
}

}  // namespace raysweep
