// OpenMP by hand against the schedulers on OpenMP. Compiled like the module of this compiler, on its runtime.
#include <omp.h>

#include "experiments/overhead/busy_work.h"
#include "experiments/overhead/direct.h"

namespace raysweep {

namespace {

std::vector<DirectLoop> loops(int threads) {
  omp_set_dynamic(0);  // as the schedulers: the team is as large as asked for
  return {{"schedule(dynamic, 1)", "omp_dynamic",
           [threads](size_t items, const Body& body, std::uint64_t) {
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
             for (size_t i = 0; i < items; ++i) body(i, i + 1, omp_get_thread_num());
           }},
          {"schedule(static, 1)", "omp_static_chunk",
           [threads](size_t items, const Body& body, std::uint64_t) {
#pragma omp parallel for schedule(static, 1) num_threads(threads)
             for (size_t i = 0; i < items; ++i) body(i, i + 1, omp_get_thread_num());
           }},
          {"schedule(static)", "omp_static",
           [threads](size_t items, const Body&, std::uint64_t iterations) {
#pragma omp parallel for schedule(static) num_threads(threads)
             for (size_t i = 0; i < items; ++i) busy_work(iterations);
           }},
          {"schedule(guided)", "omp_guided", [threads](size_t items, const Body&, std::uint64_t iterations) {
#pragma omp parallel for schedule(guided) num_threads(threads)
             for (size_t i = 0; i < items; ++i) busy_work(iterations);
           }}};
}

#ifdef __clang__
constexpr const char* runtime = "libomp";
#else
constexpr const char* runtime = "libgomp";
#endif

}  // namespace

}  // namespace raysweep

int main(int argc, char** argv) {
  return raysweep::compare_directly({"overhead_direct_openmp", raysweep::runtime, raysweep::loops}, argc,
                                    argv);
}
