// Threads bound to processors. Each worker binds itself, whoever made it: what is asked of std::thread,
// OpenMP and TBB is then the same.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace raysweep {

/// A set of processors, by the operating system's numbers, ascending.
using ProcessorSet = std::vector<int>;

/// The processors that the calling thread may run on. Throws std::system_error if they cannot be read.
[[nodiscard]] ProcessorSet allowed_processors();

/// Binds the calling thread. False if the system does not allow any of them; nothing has changed then.
bool bind_this_thread(const ProcessorSet& processors) noexcept;

/// Which worker runs where: worker w on processors[w % size]; empty: wherever the system likes.
class Binding {
 public:
  explicit Binding(std::vector<int> processors) : processors_(std::move(processors)) {}
  [[nodiscard]] bool none() const { return processors_.empty(); }
  [[nodiscard]] int processor(int worker) const {
    return processors_[static_cast<size_t>(worker) % processors_.size()];
  }
  /// Binds the calling thread as `worker`; does nothing without a placement. That it worked is seen, and
  /// told, where workers are asked for their processors: see `processors_of_workers`.
  void bind(int worker) const noexcept {
    if (!none()) (void)bind_this_thread({processor(worker)});
  }

 private:
  std::vector<int> processors_;
};

/// Binds the thread that makes it, as a worker, and gives it its former processors back on destruction, which
/// must happen on the same thread.
class BoundCaller {
 public:
  BoundCaller(const Binding& binding, int worker);
  ~BoundCaller();
  BoundCaller(const BoundCaller&) = delete;
  BoundCaller& operator=(const BoundCaller&) = delete;

 private:
  ProcessorSet before_;
};

}  // namespace raysweep
