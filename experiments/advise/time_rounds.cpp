#include "experiments/advise/time_rounds.h"

#include <time.h>

#include <memory>
#include <numeric>
#include <utility>

#include "experiments/clock.h"
#include "experiments/intersection/kernel.h"
#include "results/statistics/random.h"
#include "tracer/render.h"

namespace raysweep {

namespace {

/// Of this thread on a processor: pictures are made by one thread, and what others do meanwhile is not its
/// cost.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// What one run of a contestant took, in nanoseconds a ray.
using Run = std::function<double()>;

/// 0 to count − 1 in any order (Fisher & Yates).
std::vector<size_t> shuffled(size_t count, Random& random) {
  std::vector<size_t> order(count);
  std::iota(order.begin(), order.end(), size_t{0});
  for (size_t left = count; left > 1; --left) std::swap(order[left - 1], order[random.index(left)]);
  return order;
}

/// All `runs` once, which is not counted: caches and pages get warm. Then in rounds, each in another order,
/// while `goes_on` for the seconds and the times so far, or there are too few.
template <class GoesOn>
RoundTimes run_rounds(const std::vector<Run>& runs, const RoundOptions& options, Random& random,
                      const GoesOn& goes_on) {
  RoundTimes times(runs.size());
  for (const Run& run : runs) (void)run();
  const double begin = now_seconds();
  for (int round = 0; round < options.most; ++round) {
    if (round >= options.least && !goes_on(now_seconds() - begin, times)) break;
    for (const size_t i : shuffled(runs.size(), random)) times[i].push_back(runs[i]());
  }
  return times;
}

constexpr double nanoseconds_a_second = 1e9;

/// One renderer with all that it writes to.
class Picture {
 public:
  Picture(const Scene& scene, const RenderSettings& settings)
      : whole_{0, 0, settings.width, settings.height},
        film_(settings.width, settings.height),
        renderer_(make_renderer(scene, settings)),
        workspace_(renderer_->make_workspace()) {}

  double nanoseconds_a_ray() {
    const double begin = thread_seconds();
    const RenderCounts counts = renderer_->render(whole_, film_, *workspace_);
    return (thread_seconds() - begin) * nanoseconds_a_second / static_cast<double>(counts.rays.total());
  }

 private:
  Tile whole_;
  Film film_;
  std::unique_ptr<const Renderer> renderer_;
  std::unique_ptr<Workspace> workspace_;
};

template <class T>
Workload<T> work_of(const std::vector<SampledHit>& hits) {
  Workload<T> work;
  for (const auto& [ray, triangle] : hits) {
    const auto index = static_cast<uint32_t>(work.rays.size());
    work.rays.push_back({Vec3<T>(ray.origin), Vec3<T>(ray.direction)});
    work.triangles.push_back(triangle.template as<T>());
    work.visits.push_back({index, index, 1});
  }
  return work;
}

/// Adds the base kernels of one precision.
template <class T>
void add_kernels(const Workload<T>& work, std::string_view precision, std::vector<TimedKernel>& timed,
                 std::vector<Run>& runs) {
  for (const Kernel<T>& kernel : all_kernels<T>()) {
    if (kernel.change != "base") continue;
    timed.push_back({kernel.method, precision, {}});
    const std::shared_ptr<KernelPass> pass = kernel.prepare(work);
    const double tests = static_cast<double>(work.test_count());
    runs.push_back([pass, tests] {
      const double begin = thread_seconds();
      (void)pass->run();
      return (thread_seconds() - begin) * nanoseconds_a_second / tests;
    });
  }
}

}  // namespace

PictureRace::PictureRace(const Scene& scene, const std::vector<RenderSettings>& settings,
                         const RoundOptions& options)
    : options_(options), random_(options.seed), runs_(settings.size()) {
  // Built in any order: who comes first gets other memory than who comes last.
  for (const size_t i : shuffled(settings.size(), random_)) {
    const auto picture = std::make_shared<Picture>(scene, settings[i]);
    runs_[i] = [picture] { return picture->nanoseconds_a_ray(); };
  }
}

RoundTimes PictureRace::run(const std::function<bool(const RoundTimes&)>& is_enough) {
  return run_rounds(runs_, options_, random_, [&](double seconds, const RoundTimes& times) {
    return seconds <= options_.seconds || (seconds <= options_.longest && !is_enough(times));
  });
}

std::vector<TimedKernel> time_kernels(const std::vector<SampledHit>& hits, const RoundOptions& options) {
  std::vector<TimedKernel> timed;
  if (hits.empty()) return timed;
  const Workload<float> of_floats = work_of<float>(hits);
  const Workload<double> of_doubles = work_of<double>(hits);
  std::vector<Run> runs;
  add_kernels(of_floats, "float", timed, runs);
  add_kernels(of_doubles, "double", timed, runs);
  Random random(options.seed);
  RoundTimes times = run_rounds(runs, options, random, [&](double seconds, const RoundTimes& /*times*/) {
    return seconds <= options.seconds;
  });
  for (size_t i = 0; i < timed.size(); ++i) timed[i].nanoseconds = std::move(times[i]);
  return timed;
}

}  // namespace raysweep
