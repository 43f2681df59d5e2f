// Contestants that take the time they are told to, for tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "experiments/peers/duel.h"

namespace raysweep {

/// Hits triangle `id` with every ray.
class FakeContestant final : public Contestant {
 public:
  FakeContestant(std::string name, double milliseconds, uint32_t id, std::vector<std::string>* log = nullptr)
      : name_(std::move(name)), milliseconds_(milliseconds), id_(id), log_(log) {}

  [[nodiscard]] std::string name() const override { return name_; }
  void prepare(const RayBatch& rays, bool) override { size_ = rays.size; }
  void reset() override { was_reset_ = true; }
  void run() override {
    if (!was_reset_) throw std::logic_error("not reset before a run");
    was_reset_ = false;
    if (log_) log_->push_back(name_);
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(milliseconds_));
  }
  [[nodiscard]] HitBatch hits() const override {
    HitBatch hits(size_);
    for (size_t i = 0; i < size_; ++i) hits.id[i] = id_;
    return hits;
  }

 private:
  std::string name_;
  double milliseconds_;
  uint32_t id_;
  std::vector<std::string>* log_;
  size_t size_ = 0;
  bool was_reset_ = false;
};

/// Of each duel.
inline constexpr size_t ray_count = 10;

/// A duel of contestants whose time is known.
class DuelOf : public testing::Test {
 public:
  Team ours, embree;
  RayBatch rays{ray_count};
  OracleHits oracle{HitBatch(ray_count), HitBatch(ray_count)};
  std::vector<std::string> log;
  DuelOptions options{.rounds = 8, .run_seconds = 0.001, .seed = 1};

  DuelOf() {
    std::ranges::fill(oracle.usual.id, 7u);
    std::ranges::fill(oracle.robust.id, 9u);
  }

  void enter(Team& team, const char* name, double milliseconds, bool single, bool robust = false,
             uint32_t id = 7) {
    team.entrants.push_back({std::make_unique<FakeContestant>(name, milliseconds, id, &log), single, robust});
  }

  [[nodiscard]] std::vector<Performance> run() const {
    return duel(ours, embree, rays, false, oracle, options);
  }
};

}  // namespace raysweep
