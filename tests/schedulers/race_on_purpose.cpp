// Two items write the same plain int: for ThreadSanitizer to report, on every family of schedulers. Were it
// silent here, its silence elsewhere would mean nothing.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "schedulers/registry.h"

int main(int count, char** arguments) {
  using namespace raysweep;
  if (count < 2) return 2;
  const std::string name = arguments[1], runtime = count > 2 ? arguments[2] : "";
  if (const std::string why = why_unavailable(*find_scheduler(name), runtime); !why.empty()) {
    std::printf("skipped: %s is %s\n", name.c_str(), why.c_str());
    return 0;
  }
  const auto scheduler = make_scheduler(name, {.threads = 2, .runtime = runtime});
  int shared = 0;
  std::atomic<int> arrived{0};
  WorkerLog log(2);
  const auto body = [&](size_t, size_t, int) {
    shared++;
    // Each waits for the other after its write, so that two workers write. Relaxed: orders nothing.
    arrived.fetch_add(1, std::memory_order_relaxed);
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (arrived.load(std::memory_order_relaxed) < 2 && std::chrono::steady_clock::now() < give_up)
      std::this_thread::yield();
  };
  scheduler->run({2}, {1}, body, log);
  std::printf("%d items wrote without a report\n", shared);
}
