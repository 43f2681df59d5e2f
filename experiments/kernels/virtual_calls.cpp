// Calls of functions that are known only when they are called. Objects are of four types, each with a
// function of its own, of one operation on a whole number: what is left is the call.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <variant>

#include "experiments/kernels/keep.h"
#include "experiments/kernels/small_kernel.h"
#include "results/statistics/random.h"

namespace raysweep {

namespace {

constexpr size_t type_count = 4;

template <size_t type>
uint64_t step(uint64_t value) {
  if constexpr (type == 0) return value + 7;
  if constexpr (type == 1) return value * 5;
  if constexpr (type == 2) return value ^ 0x55U;
  return value >> 1U;
}

struct Item {
  size_t type;
  uint64_t value;
};

std::vector<Item> random_items(size_t count, uint64_t seed) {
  Random random(seed);
  std::vector<Item> items(count);
  for (Item& item : items) item = {random.index(type_count), random.index(1U << 20U)};
  return items;
}

struct Object {
  Object() = default;
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;
  virtual ~Object() = default;
  [[nodiscard]] virtual uint64_t work() const = 0;
};

template <size_t type>
struct ObjectOf final : Object {
  explicit ObjectOf(uint64_t v) : value(v) {}
  [[nodiscard]] uint64_t work() const override { return step<type>(value); }
  uint64_t value;
};

template <size_t type>
struct Value {
  uint64_t value;
  [[nodiscard]] uint64_t work() const { return step<type>(value); }
};

/// `make` of the type that an item has.
template <class Make>
auto by_type(const Item& item, Make&& make) {
  switch (item.type) {
    case 0:
      return make(std::integral_constant<size_t, 0>());
    case 1:
      return make(std::integral_constant<size_t, 1>());
    case 2:
      return make(std::integral_constant<size_t, 2>());
    default:
      return make(std::integral_constant<size_t, 3>());
  }
}

uint64_t work_of(const Item& item) {
  return by_type(item, [&](auto type) { return step<type>(item.value); });
}

// Each of these holds objects and calls them all. Objects lie in memory in the order of the calls.

class Virtual {
 public:
  explicit Virtual(const std::vector<Item>& items) {
    objects_.reserve(items.size());
    for (const Item& item : items) {
      objects_.push_back(by_type(item, [&](auto type) -> std::unique_ptr<Object> {
        return std::make_unique<ObjectOf<type>>(item.value);
      }));
    }
  }
  [[nodiscard]] uint64_t call() const {
    uint64_t sum = 0;
    for (const auto& object : objects_) sum += object->work();
    return sum;
  }

 private:
  std::vector<std::unique_ptr<Object>> objects_;
};

class VirtualSorted : public Virtual {
 public:
  explicit VirtualSorted(std::vector<Item> items) : Virtual(sorted(std::move(items))) {}

 private:
  static std::vector<Item> sorted(std::vector<Item> items) {
    std::ranges::stable_sort(items, {}, &Item::type);
    return items;
  }
};

class Variants {
 public:
  explicit Variants(const std::vector<Item>& items) {
    for (const Item& item : items)
      objects_.push_back(by_type(item, [&](auto type) -> Any { return Value<type>{item.value}; }));
  }
  [[nodiscard]] uint64_t call() const {
    uint64_t sum = 0;
    for (const Any& object : objects_)
      sum += std::visit([](const auto& value) { return value.work(); }, object);
    return sum;
  }

 private:
  using Any = std::variant<Value<0>, Value<1>, Value<2>, Value<3>>;
  std::vector<Any> objects_;
};

class PerType {
 public:
  explicit PerType(const std::vector<Item>& items) {
    for (const Item& item : items)
      by_type(item, [&](auto type) { std::get<type>(objects_).push_back({item.value}); });
  }
  [[nodiscard]] uint64_t call() const {
    return std::apply([](const auto&... list) { return (sum_of(list) + ...); }, objects_);
  }

 private:
  static uint64_t sum_of(const auto& list) {
    uint64_t sum = 0;
    for (const auto& value : list) sum += value.work();
    return sum;
  }

  std::tuple<std::vector<Value<0>>, std::vector<Value<1>>, std::vector<Value<2>>, std::vector<Value<3>>>
      objects_;
};

/// Objects as `Virtual` has them, but all of one type that the compiler knows, and a call that stays one.
class Direct {
 public:
  explicit Direct(const std::vector<Item>& items) {
    for (const Item& item : items) objects_.push_back(std::make_unique<ObjectOf<0>>(item.value));
  }
  [[nodiscard]] uint64_t call() const {
    uint64_t sum = 0;
    for (const auto& object : objects_) sum += work(*object);
    return sum;
  }

 private:
  [[gnu::noinline]] static uint64_t work(const ObjectOf<0>& object) {
    keep(object);  // or it would be known to depend on the object alone, and be computed elsewhere
    return object.work();
  }

  std::vector<std::unique_ptr<ObjectOf<0>>> objects_;
};

template <class Objects>
class CallPass : public SmallPass {
 public:
  CallPass(size_t length, bool is_first, uint64_t seed)
      : objects_(random_items(length, seed)),
        others_(random_items(is_first ? other_count : 0, seed + 1)),
        repeats_(is_first ? 1 : std::max(size_t{1}, least_calls / length)),
        length_(length),
        is_first_(is_first) {
    for (Item item : random_items(length, seed)) {
      if (std::is_same_v<Objects, Direct>) item.type = 0;
      expected_ += work_of(item);
    }
  }

  [[nodiscard]] uint64_t operations() const override { return repeats_ * length_; }
  double run() override {
    uint64_t sum = 0;
    for (size_t i = 0; i < repeats_; ++i) sum += call(objects_);
    return static_cast<double>(sum);
  }
  [[nodiscard]] std::string why_wrong() override {
    const uint64_t sum = call(objects_);
    return sum == expected_ ? "" : fmt::format("the calls' sum is {}, where {} is right", sum, expected_);
  }
  [[nodiscard]] bool is_disturbed() const override { return is_first_; }
  void disturb() override {
    const uint64_t sum = call(others_);
    keep(sum);
  }

 private:
  // Of a short array one pass takes no longer than reading a clock.
  static constexpr size_t least_calls = 16'384;
  // Their 2 MB are more than what is left of the array in the first and, mostly, the second cache, and their
  // types, in an order of their own, more than what branch predictors remember.
  static constexpr size_t other_count = 65'536;

  /// One place for both, so that the predictor takes the calls for the same.
  [[gnu::noinline]] static uint64_t call(const Objects& objects) {
    keep(objects);
    return objects.call();
  }

  Objects objects_, others_;
  size_t repeats_, length_;
  bool is_first_;
  uint64_t expected_ = 0;
};

/// Making an object takes longer than calling it; what disturbs a first pass takes ten times a millisecond.
double rough_seconds_of_virtual_calls(const FactorValues& values) {
  const double objects = number_of(values, "length") * 50e-9;
  return objects + (values.at("pass") == "first" ? 0.01 : 0);
}

std::unique_ptr<SmallPass> prepare_virtual_calls(const FactorValues& values, uint64_t seed) {
  const auto length = static_cast<size_t>(number_of(values, "length"));
  const bool is_first = values.at("pass") == "first";
  const std::string& dispatch = values.at("dispatch");
  if (dispatch == "virtual_sorted") return std::make_unique<CallPass<VirtualSorted>>(length, is_first, seed);
  if (dispatch == "variant") return std::make_unique<CallPass<Variants>>(length, is_first, seed);
  if (dispatch == "per_type") return std::make_unique<CallPass<PerType>>(length, is_first, seed);
  if (dispatch == "direct") return std::make_unique<CallPass<Direct>>(length, is_first, seed);
  return std::make_unique<CallPass<Virtual>>(length, is_first, seed);
}

}  // namespace

SmallKernel virtual_calls_kernel() {
  return {"virtual_calls",
          "a call of each object of an array, of four types in random order",
          "call",
          {{"dispatch", {"virtual", "virtual_sorted", "variant", "per_type", "direct"}},
           {"length", {}, 1, 1e6, 1, {1, 10, 100, 1000, 1e4, 1e5, 1e6}},
           {"pass", {"first", "repeated"}}},
          [](const FactorValues&) { return std::string(); },
          prepare_virtual_calls,
          rough_seconds_of_virtual_calls};
}

}  // namespace raysweep
