#include "experiments/limits/batch_runs.h"

#include <ctime>
#include <memory>

#include "results/statistics/statistics.h"

namespace raysweep {

namespace {

constexpr uint64_t ray_seed = 1;

double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <int width>
auto tracer_of(const Scene& scene, const std::string& isa) {
  const auto core = std::make_shared<const WideCore<MollerTrumbore, width>>(scene, "sah", 4, isa);
  return
      [core](const RayBatch& rays, HitBatch& hits, KernelScratch& scratch, bool any_hit, Grouping grouping) {
        if (any_hit) {
          core->occluded(rays, hits, scratch, grouping);
        } else {
          core->closest(rays, hits, scratch, grouping);
        }
      };
}

/// What one way of tracing reads and writes, the same memory each time.
struct Batch {
  std::shared_ptr<const RayBatch> rays;
  HitBatch hits;
  KernelScratch scratch;
};

/// Of one of as many repetitions as take `least`.
double mean_seconds(const BatchRun& run, double least) {
  const double begin = cpu_now();
  double seconds = 0;
  int repeats = 0;
  for (; seconds < least || repeats == 0; ++repeats) {
    run.trace();
    seconds = cpu_now() - begin;
  }
  return seconds / repeats;
}

}  // namespace

SceneRuns::SceneRuns(Scene scene, const std::vector<std::string>& isas)
    : scene_(triangles_alone(std::move(scene))), oracle_(scene_, "sah", 4) {
  for (const std::string& isa : isas) {
    const auto of_isa = std::ranges::find_if(built_isas(), [&](const Isa& i) { return i.name == isa; });
    cores_.emplace_back(
        isa, of_isa->width == 8 ? Trace(tracer_of<8>(scene_, isa)) : Trace(tracer_of<4>(scene_, isa)));
  }
}

std::vector<BatchRun> SceneRuns::runs(RayKind kind, int width, int height) const {
  const auto rays =
      std::make_shared<const RayBatch>(make_rays(kind, scene_, oracle_, width, height, ray_seed));
  std::vector<BatchRun> runs;
  for (const auto& core : cores_) {
    for (const Grouping grouping : {Grouping::single, Grouping::packets}) {
      const auto batch = std::make_shared<Batch>(Batch{rays, HitBatch(rays->size), {}});
      runs.push_back({core.first, grouping, rays->size,
                      [trace = core.second, batch, grouping, any_hit = asks_any_hit(kind)] {
                        batch->scratch.visits = {};
                        trace(*batch->rays, batch->hits, batch->scratch, any_hit, grouping);
                        return batch->scratch.visits;
                      }});
    }
  }
  return runs;
}

std::vector<double> cpu_seconds(const std::vector<BatchRun>& runs, int rounds, double seconds) {
  std::vector<std::vector<double>> samples(runs.size());
  for (int round = 0; round < rounds; ++round)
    for (size_t i = 0; i < runs.size(); ++i) samples[i].push_back(mean_seconds(runs[i], seconds));
  std::vector<double> medians;
  for (const auto& of_run : samples) medians.push_back(median(of_run));
  return medians;
}

double measure_gigahertz() {
  // Each step waits for the one before: 1 cycle for the exclusive or, 3 for the product, on x86-64 processors
  // since 2011 (Intel) and 2017 (AMD); Fog, "Instruction tables".
  constexpr int cycles_per_step = 4;
  constexpr uint64_t steps = 5'000'000;
  std::vector<double> samples;
  for (int i = 0; i < 9; ++i) {
    uint64_t x = 1;
    const double begin = cpu_now();
    for (uint64_t step = 0; step < steps; ++step) x = (x ^ step) * 0x9e3779b97f4a7c15u;
    const volatile uint64_t kept = x;
    static_cast<void>(kept);
    samples.push_back(cycles_per_step * static_cast<double>(steps) * 1e-9 / (cpu_now() - begin));
  }
  return median(samples);
}

}  // namespace raysweep
