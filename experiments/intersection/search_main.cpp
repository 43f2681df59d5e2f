// Which inputs are the worst of each method? Prints them as scripts/search_worst keeps them.
#include <fmt/format.h>

#include "experiments/intersection/worst_inputs.h"

namespace raysweep {

namespace {

int print_worst_inputs() {
  fmt::print("{}\n", worst_inputs_head);
  for (const Wrong what :
       {Wrong::false_miss, Wrong::false_hit, Wrong::t_error, Wrong::weight_error, Wrong::leak}) {
    for (const Domain domain : {Domain::tame, Domain::any}) {
      SearchSettings settings;
      settings.what = what;
      settings.domain = domain;
      for (const WorstInput& input : worst_inputs(settings)) fmt::print("{}\n", to_line(input));
      fmt::print(stderr, "{}, {}\n", wrong_names[static_cast<size_t>(what)],
                 domain_names[static_cast<size_t>(domain)]);
    }
  }
  return 0;
}

}  // namespace

}  // namespace raysweep

int main() { return raysweep::print_worst_inputs(); }
