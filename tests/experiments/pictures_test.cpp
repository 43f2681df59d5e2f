// One picture, whoever shares it out and however.
#include <gtest/gtest.h>

#include "experiments/render_job.h"
#include "schedulers/registry.h"
#include "tests/schedulers/available.h"

namespace raysweep {
namespace {

class Pictures : public testing::TestWithParam<Tested> {};
INSTANTIATE_TEST_SUITE_P(registry, Pictures, testing::ValuesIn(available_schedulers()),
                         [](const auto& i) { return i.param.name(); });

#ifdef RAYSWEEP_TSAN
// A race among workers shows however items are shared out, and a scene takes ten times as long to load: one
// sharing, the one in which workers write closest to each other.
const std::vector<int> thread_counts{3}, chunk_values{1}, depths{1, 1024};
const std::vector<const char*> shapes{"columns"};
#else
const std::vector<int> thread_counts{1, 2, 3, 7}, chunk_values{1, 16}, depths{1, 2, 64, 1024};
const std::vector<const char*> shapes{"rows", "columns", "tiles:7"};
#endif

Cell small_cell() {
  Cell cell;
  cell.scene = "many-lights";  // no mesh, which would be made anew for each of a hundred pictures
  cell.settings.width = 40;
  cell.settings.height = 30;
  cell.settings.subpixels = 2;
  cell.lights = 2;
  return cell;
}

void choose(Cell& cell, const Tested& tested) {
  cell.scheduler = tested.scheduler;
  cell.runtime = tested.runtime.empty() ? "default" : tested.runtime;
}

std::string picture(const Cell& cell, RayCounts* rays = nullptr) {
  RenderJob job(cell);
  job.frame();
  if (rays) *rays = job.rays();
  return job.film().hash();
}

TEST_P(Pictures, one_hash_for_all_threads_chunks_and_items) {
  for (const Choice& core : cores()) {
    for (const Choice& precision : precisions()) {
      if (core.name == "wide" && precision.name != "float") continue;
      Cell cell = small_cell();
      cell.settings.core = core.name;
      cell.settings.precision = precision.name;
      RayCounts expected_rays;
      const std::string expected = picture(cell, &expected_rays);
      choose(cell, GetParam());
      for (const int threads : thread_counts) {
        for (const int chunk : chunk_values) {
          for (const char* item : shapes) {
            cell.threads = threads;
            cell.chunk.value = chunk;
            cell.item = item;
            collapse_ignored_factors(cell);
            RayCounts rays;
            EXPECT_EQ(picture(cell, &rays), expected) << cell.key();
            EXPECT_EQ(rays, expected_rays) << cell.key();
          }
        }
      }
    }
  }
}

TEST_P(Pictures, one_hash_for_all_orders) {
  Cell cell = small_cell();
  cell.item = "tiles:7";
  const std::string expected = picture(cell);
  choose(cell, GetParam());
  cell.threads = 3;
  for (const OrderInfo& order : item_orders()) {
    cell.order = order.name;
    RenderJob job(cell);
    for (int frame = 0; frame < 2; ++frame) {
      job.frame();
      EXPECT_EQ(job.film().hash(), expected) << order.name;
      job.reset();
    }
  }
}

TEST_P(Pictures, a_second_frame_is_the_first_one) {
  Cell cell = small_cell();
  choose(cell, GetParam());
  cell.threads = 3;
  collapse_ignored_factors(cell);
  RenderJob job(cell);
  job.frame();
  const std::string first = job.film().hash();
  const RayCounts rays = job.rays();
  job.reset();
  job.frame();
  EXPECT_EQ(job.film().hash(), first);
  EXPECT_EQ(job.rays(), rays);
}

TEST_P(Pictures, every_depth_to_1024_renders_on_the_workers_stacks) {
  for (const Choice& core : cores()) {
    Cell cell = small_cell();
    cell.settings.core = core.name;
    for (const int depth : depths) {
      cell.settings.depth = depth;
      cell.scheduler = "serial";
      cell.threads = 1;
      RayCounts rays;
      const std::string expected = picture(cell, &rays);
      choose(cell, GetParam());
      cell.threads = 3;
      collapse_ignored_factors(cell);
      EXPECT_EQ(picture(cell), expected) << depth;
    }
  }
}

}  // namespace
}  // namespace raysweep
