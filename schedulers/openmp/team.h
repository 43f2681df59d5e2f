// What all OpenMP schedulers share: a team of one size, made and bound once.
#pragma once

#include <omp.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "schedulers/binding.h"
#include "schedulers/options.h"
#include "schedulers/scheduler.h"
#include "schedulers/work.h"

namespace raysweep {

/// The team has the same size in every run: changing it costs 50 to 80 µs in libgomp.
class OmpScheduler : public Scheduler {
 public:
  explicit OmpScheduler(const SchedulerOptions& options)
      : threads_(options.threads), binding_(options.processors) {
    omp_set_dynamic(0);  // the team is as large as asked for, or the record shows it
    if (binding_.none()) return;
    // Before the caller is bound: threads begin with the mask of the one that made them.
    before_.resize(static_cast<size_t>(threads_));
#pragma omp parallel num_threads(threads_)
    {
      const int worker = omp_get_thread_num();
      before_[static_cast<size_t>(worker)] = allowed_processors();
      binding_.bind(worker);
    }
  }

  /// The team outlives this object, in the runtime: it gets its processors back.
  ~OmpScheduler() override {
    if (binding_.none()) return;
#pragma omp parallel num_threads(threads_)
    (void)bind_this_thread(before_[static_cast<size_t>(omp_get_thread_num())]);
  }

 protected:
  [[nodiscard]] int threads() const { return threads_; }

 private:
  virtual void run_team(const ItemSpace& items, const Chunk& chunk, const Work& work) = 0;

  void run_items(const ItemSpace& items, const Chunk& chunk, const Work& work) final {
    work.before_all();
    run_team(items, chunk, work);
    work.after_all();
  }

  int threads_;
  Binding binding_;
  std::vector<ProcessorSet> before_;  // each worker's, before it was bound
};

template <class S>
std::unique_ptr<Scheduler> make_omp(const SchedulerOptions& options) {
  return std::make_unique<S>(options);
}

inline std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

}  // namespace raysweep
