#include "schedulers/work.h"

#ifdef RAYSWEEP_TSAN
// As <sanitizer/tsan_interface.h>, which not every compiler brings; they are in the program's runtime.
extern "C" void __tsan_acquire(void*);
extern "C" void __tsan_release(void*);
#endif

namespace raysweep {

void Work::operator()(const Block& block, size_t columns, int worker) const noexcept {
  if (error_.raised()) return;
  const Entered entered(*this);
  const size_t width = block.last_column - block.first_column;
  log_.begin_chunk(worker, block.first_row * columns + block.first_column,
                   width * (block.last_row - block.first_row));
  for (size_t row = block.first_row; row < block.last_row; ++row) {
    const size_t begin = row * columns + block.first_column;
    call(begin, begin + width, worker);
  }
  log_.end_chunk(worker);
}

void Work::item(size_t i, int worker) const noexcept {
  if (error_.raised()) return;
  const Entered entered(*this);
  log_.begin_item(worker, i);
  call(i, i + 1, worker);
  log_.end_chunk(worker);
}

// ThreadSanitizer sees only what is compiled with it. libgomp, libomp and TBB are not: they hand work from
// thread to thread by futexes and atomics of their own, which it misses, and it would report every item as a
// race with the caller. So the contract is told to it: what the caller did before the run happens before each
// chunk, and each chunk before what the caller does after it. Chunks get no order among themselves: two that
// touch the same memory are still reported. Schedulers on std::thread tell nothing: there it sees all.
#ifdef RAYSWEEP_TSAN
Work::Entered::Entered(const Work& work) noexcept : work_(work) {
  __tsan_acquire(const_cast<Body*>(&work_.body_));
}
Work::Entered::~Entered() { __tsan_release(&work_.log_); }
void Work::before_all() const noexcept { __tsan_release(const_cast<Body*>(&body_)); }
void Work::after_all() const noexcept { __tsan_acquire(&log_); }
#else
void Work::before_all() const noexcept {}
void Work::after_all() const noexcept {}
#endif

}  // namespace raysweep
