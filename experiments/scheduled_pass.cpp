#include "experiments/scheduled_pass.h"

#include "schedulers/registry.h"

namespace raysweep {

std::vector<std::string_view> kernel_schedulers() {
  std::vector<std::string_view> names;
  for (const SchedulerInfo& info : all_schedulers()) {
    if (info.uses_threads && !info.uses_runtime()) names.push_back(info.name);
  }
  return names;
}

ScheduledPass::ScheduledPass(const std::string& scheduler, int threads, std::vector<TimedPass> parts)
    : parts_(std::move(parts)),
      found_(parts_.size()),
      log_(threads),
      body_([this](size_t begin, size_t end, int) {
        for (size_t i = begin; i < end; ++i) found_[i].value = parts_[i]();
      }),
      scheduler_(make_scheduler(scheduler, {.threads = threads})) {}

double ScheduledPass::run() {
  scheduler_->run({.count = parts_.size()}, Chunk{}, body_, log_);
  double sum = 0;
  for (const Found& part : found_) sum += part.value;
  return sum;
}

}  // namespace raysweep
