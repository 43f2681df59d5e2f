#include "experiments/machine/sibling_probe.h"

#include <gtest/gtest.h>

#include "schedulers/binding.h"

namespace raysweep {
namespace {

TEST(sibling_probe, agrees_where_threads_of_a_core_halve_each_other_and_others_do_not) {
  const Topology topology = synthetic_topology("core:2 pu:2");
  const int a = topology.hardware_threads[0].processor, sibling = topology.hardware_threads[1].processor,
            other = topology.hardware_threads[2].processor;
  EXPECT_TRUE(disagreements({{a, sibling, 1.9}, {a, other, 1.1}, {sibling, other, 1.0}}, topology).empty());
}

TEST(sibling_probe, a_topology_that_lies_is_told) {
  const Topology topology = synthetic_topology("core:2 pu:2");
  const int a = topology.hardware_threads[0].processor, sibling = topology.hardware_threads[1].processor,
            other = topology.hardware_threads[2].processor;
  const auto sentences = disagreements({{a, sibling, 1.0}, {a, other, 1.8}}, topology);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_NE(sentences[0].find("share a core, says the topology"), std::string::npos) << sentences[0];
  EXPECT_NE(sentences[0].find("they do not share one"), std::string::npos) << sentences[0];
  EXPECT_NE(sentences[1].find("do not share a core, says the topology"), std::string::npos) << sentences[1];
  EXPECT_NE(sentences[1].find("1.80 times as long"), std::string::npos) << sentences[1];
}

TEST(sibling_probe, tries_every_pair_of_this_machine_once) {
  auto processors = allowed_processors();
  processors.resize(std::min<size_t>(processors.size(), 4));
  const auto pairs = probe_siblings(processors);
  EXPECT_EQ(pairs.size(), processors.size() * (processors.size() - 1) / 2);
  for (const PairSlowdown& pair : pairs) {
    EXPECT_LT(pair.first, pair.second);
    EXPECT_GT(pair.slowdown, 0);
  }
}

}  // namespace
}  // namespace raysweep
