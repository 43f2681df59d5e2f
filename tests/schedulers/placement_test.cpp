// Policies on machines that need not be here: hwloc builds them from a description.
#include "schedulers/placement.h"

#include <gtest/gtest.h>
#include <hwloc.h>

#include <set>

namespace raysweep {
namespace {

using List = std::vector<int>;

const Topology m11 = synthetic_topology("pack:1 core:6 pu:2");  // Morozov 2011's i7-980X
const Topology two_packages = synthetic_topology("pack:2 l3:2 core:2 pu:2");

/// 6 fast cores with two hardware threads, then 8 slow ones with one.
Topology hybrid() {
  hwloc_topology_t raw = nullptr;
  hwloc_topology_init(&raw);
  hwloc_topology_set_synthetic(raw, "pack:1 l3:1 core:14 pu:2");
  hwloc_topology_load(raw);
  hwloc_bitmap_t all = hwloc_bitmap_alloc(), slow = hwloc_bitmap_alloc(), fast = hwloc_bitmap_alloc();
  hwloc_bitmap_set_range(fast, 0, 11);
  for (unsigned pu = 12; pu < 28; pu += 2) hwloc_bitmap_set(slow, pu);
  hwloc_bitmap_or(all, fast, slow);
  hwloc_topology_restrict(raw, all, 0);
  hwloc_cpukinds_register(raw, slow, 0, 0, nullptr, 0);
  hwloc_cpukinds_register(raw, fast, 1, 0, nullptr, 0);
  Topology topology = read_topology(raw);
  for (const hwloc_bitmap_t set : {all, slow, fast}) hwloc_bitmap_free(set);
  hwloc_topology_destroy(raw);
  return topology;
}

std::set<int> cores_of(const List& processors, const Topology& topology) {
  std::set<int> cores;
  for (const int p : processors) cores.insert(topology.find(p)->core);
  return cores;
}

TEST(topology, counts_what_is_described) {
  EXPECT_EQ(m11.cores(), 6);
  EXPECT_EQ(m11.processors(), 12);
  EXPECT_TRUE(m11.has_smt());
  EXPECT_EQ(two_packages.packages(), 2);
  EXPECT_EQ(two_packages.find(15)->cache, 3);
  EXPECT_EQ(two_packages.find(16), nullptr);
  EXPECT_EQ(hybrid().cores(), 14);
  EXPECT_EQ(hybrid().processors(), 20);
  EXPECT_THROW((void)synthetic_topology("six cores"), TopologyError);
}

TEST(placement, none_places_nobody) { EXPECT_EQ(place("none", 4, m11), List()); }

TEST(placement, cores_takes_every_core_once_before_any_twice) {
  EXPECT_EQ(place("cores", 6, m11), (List{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(place("cores", 12, m11), (List{0, 2, 4, 6, 8, 10, 1, 3, 5, 7, 9, 11}));
}

TEST(placement, compact_fills_a_core_before_the_next) {
  EXPECT_EQ(place("compact", 5, m11), (List{0, 1, 2, 3, 4}));
}

TEST(placement, scatter_alternates_packages_and_caches) {
  // Processors 0–7 and 8–15 are the packages, each 0–3 and 4–7 the caches.
  EXPECT_EQ(place("scatter", 8, two_packages), (List{0, 8, 4, 12, 2, 10, 6, 14}));
  const List all = place("scatter", 16, two_packages);
  EXPECT_EQ(List(all.begin() + 8, all.end()), (List{1, 9, 5, 13, 3, 11, 7, 15}))
      << "second hardware threads last";
}

TEST(placement, one_core_is_both_hardware_threads_of_one) {
  EXPECT_EQ(place("one_core", 4, m11), (List{0, 1, 0, 1}));
  EXPECT_EQ(place("one_core", 2, synthetic_topology("core:4 pu:1")), (List{0, 0}))
      << "no second one to be had";
}

TEST(placement, a_list_is_taken_in_its_order_and_anew_when_it_ends) {
  EXPECT_EQ(place("9,0-2", 6, m11), (List{9, 0, 1, 2, 9, 0}));
}

TEST(placement, more_threads_than_processors_begin_anew) {
  const List placed = place("compact", 25, m11);
  EXPECT_EQ(placed[12], 0);
  EXPECT_EQ(placed[24], 0);
}

TEST(placement, fast_cores_come_first_on_a_hybrid_machine) {
  const Topology machine = hybrid();
  EXPECT_EQ(place("cores", 6, machine), (List{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(cores_of(place("cores", 14, machine), machine).size(), 14u)
      << "slow cores before second siblings";
  EXPECT_EQ(place("compact", 12, machine), (List{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
}

TEST(placement, a_large_machine_gets_each_processor_once) {
  const Topology large = synthetic_topology("pack:2 numa:4 l3:4 core:4 pu:2");
  ASSERT_EQ(large.cores(), 128);
  for (const char* pin : {"cores", "compact", "scatter"}) {
    const List placed = place(pin, 256, large);
    EXPECT_EQ(std::set<int>(placed.begin(), placed.end()).size(), 256u) << pin;
    const List first(placed.begin(), placed.begin() + 128);
    EXPECT_EQ(cores_of(first, large).size(), std::string(pin) == "compact" ? 64u : 128u) << pin;
  }
  const List four = place("scatter", 4, large);
  EXPECT_EQ(large.find(four[0])->package, 0);
  EXPECT_EQ(large.find(four[1])->package, 1);
  EXPECT_NE(large.find(four[0])->cache, large.find(four[2])->cache);
}

TEST(placement, what_is_no_pin_is_told_with_what_is_possible) {
  EXPECT_EQ(pin_problem("scatter", m11.processor_numbers()), "");
  EXPECT_EQ(pin_problem("0,11", m11.processor_numbers()), "");
  EXPECT_EQ(pin_problem("0,12", m11.processor_numbers()),
            "pin = 0,12: processor 12 is not allowed here; allowed: 0-11");
  for (const char* wrong : {"", "spread", "LIST", "1,", "1-", "3-1", "0x1", "-1", "1,,2", "99999999999"}) {
    EXPECT_NE(pin_problem(wrong, {}).find("unknown pin"), std::string::npos) << wrong;
  }
}

TEST(hyper_threading, places_one_two_and_packed_on_a_published_machine) {
  const auto p = hyper_threading_placements(m11);
  ASSERT_TRUE(p);
  EXPECT_EQ(p->cores, 6);
  EXPECT_EQ(p->one_each, (List{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(cores_of(p->two_each, m11).size(), 6u);
  EXPECT_EQ(std::set<int>(p->two_each.begin(), p->two_each.end()).size(), 12u);
  EXPECT_EQ(p->packed, (List{0, 1, 2, 3, 4, 5}));
}

TEST(hyper_threading, is_about_the_cores_that_have_it) {
  const Topology machine = hybrid();
  const auto p = hyper_threading_placements(machine);
  ASSERT_TRUE(p);
  EXPECT_EQ(p->cores, 6);
  EXPECT_EQ(p->two_each.size(), 12u);
  EXPECT_FALSE(hyper_threading_placements(synthetic_topology("pack:1 core:8 pu:1")));
}

TEST(hyper_threading, leaves_an_odd_core_out_and_packs_no_single_core) {
  EXPECT_EQ(hyper_threading_placements(synthetic_topology("core:5 pu:2"))->cores, 4);
  const auto single = hyper_threading_placements(synthetic_topology("core:1 pu:2"));
  EXPECT_EQ(single->one_each, List{0});
  EXPECT_EQ(single->two_each, (List{0, 1}));
  EXPECT_TRUE(single->packed.empty());
}

TEST(hyper_threading, takes_two_of_four_hardware_threads) {
  const auto p = hyper_threading_placements(synthetic_topology("core:2 pu:4"));
  EXPECT_EQ(p->two_each, (List{0, 1, 4, 5}));
  EXPECT_EQ(p->packed, (List{0, 1}));
}

}  // namespace
}  // namespace raysweep
