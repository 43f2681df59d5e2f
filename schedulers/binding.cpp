#include "schedulers/binding.h"

#include <sched.h>

#include <cerrno>
#include <memory>
#include <new>
#include <system_error>

namespace raysweep {

namespace {

/// A mask for more processors than cpu_set_t's 1024.
class Mask {
 public:
  explicit Mask(int processors)
      : count_(processors),
        set_(CPU_ALLOC(static_cast<size_t>(processors)), [](cpu_set_t* s) { CPU_FREE(s); }) {
    if (!set_) throw std::bad_alloc();
    CPU_ZERO_S(bytes(), set_.get());
  }
  [[nodiscard]] size_t bytes() const { return CPU_ALLOC_SIZE(static_cast<size_t>(count_)); }
  [[nodiscard]] cpu_set_t* get() const { return set_.get(); }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] bool has(int processor) const {
    return CPU_ISSET_S(static_cast<size_t>(processor), bytes(), get());
  }
  void add(int processor) { CPU_SET_S(static_cast<size_t>(processor), bytes(), get()); }

 private:
  int count_;
  std::unique_ptr<cpu_set_t, void (*)(cpu_set_t*)> set_;
};

}  // namespace

ProcessorSet allowed_processors() {
  // The kernel refuses masks that are smaller than its own.
  for (int size = 1024;; size *= 2) {
    const Mask mask(size);
    if (sched_getaffinity(0, mask.bytes(), mask.get()) == 0) {
      ProcessorSet set;
      for (int p = 0; p < size; ++p) {
        if (mask.has(p)) set.push_back(p);
      }
      return set;
    }
    if (errno != EINVAL || size >= 1 << 20)
      throw std::system_error(errno, std::generic_category(), "the allowed processors cannot be read");
  }
}

bool bind_this_thread(const ProcessorSet& processors) noexcept {
  try {
    Mask mask(processors.empty() ? 1 : processors.back() + 1);
    for (const int p : processors) mask.add(p);
    return sched_setaffinity(0, mask.bytes(), mask.get()) == 0;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

BoundCaller::BoundCaller(const Binding& binding, int worker) {
  if (binding.none()) return;
  before_ = allowed_processors();
  binding.bind(worker);
}

// Where the system took the former processors away meanwhile, the present one is as good as any.
BoundCaller::~BoundCaller() {
  if (!before_.empty()) (void)bind_this_thread(before_);
}

}  // namespace raysweep
