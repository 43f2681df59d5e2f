#include "schedulers/builtin.h"

namespace raysweep {

namespace {

class Serial final : public Scheduler {
  void run_items(const ItemSpace& items, const Chunk&, const Body& body) override { body(0, items.count, 0); }
};

}  // namespace

std::unique_ptr<Scheduler> make_serial(int) { return std::make_unique<Serial>(); }

}  // namespace raysweep
