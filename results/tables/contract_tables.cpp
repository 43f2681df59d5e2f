#include "results/tables/contract_tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace raysweep {

namespace {

std::vector<Judgement> judgements_of(const AccuracyRecord& record, const Contract& contract) {
  const Clause* const clause = contract.clause_of(record);
  return clause ? judge(record, *clause) : std::vector<Judgement>();
}

bool holds(const std::vector<Judgement>& judgements, Outcome outcome) {
  return std::any_of(judgements.begin(), judgements.end(),
                     [&](const Judgement& one) { return one.outcome == outcome; });
}

struct Counts {
  size_t cells = 0, kept = 0, broken = 0, better = 0, unknown = 0;

  void add(const std::vector<Judgement>& judgements) {
    ++cells;
    if (judgements.empty()) {
      ++unknown;
    } else if (holds(judgements, Outcome::broken)) {
      ++broken;
    } else if (holds(judgements, Outcome::better)) {
      ++better;
    } else {
      ++kept;
    }
  }
};

/// "17 of 20000"; of t the bound that its class stands for.
std::string number_text(const Judgement& judgement, int64_t number, uint64_t rays) {
  return judgement.what == "t_error" ? fmt::format("≤ 2^{} ε", number)
                                     : fmt::format("{} of {}", number, rays);
}

}  // namespace

Table contract_table(const AccuracyResults& results, const Contract& contract) {
  Table table{"what methods promise: cells that keep it, break it, or do better than stated",
              {{"method", false}, {"precision", false}},
              {}};
  for (const char* name : {"cells", "kept", "broken", "better", "not stated"})
    table.columns.push_back({name});
  for (const std::string& method : results.methods()) {
    for (const std::string& precision : results.precisions()) {
      Counts counts;
      for (const AccuracyRecord& record : results.records()) {
        if (record.method == method && record.precision == precision)
          counts.add(judgements_of(record, contract));
      }
      if (counts.cells == 0) continue;
      table.rows.push_back({method, precision});
      for (const size_t count : {counts.cells, counts.kept, counts.broken, counts.better, counts.unknown})
        table.rows.back().push_back(std::to_string(count));
    }
  }
  return table;
}

Table contract_differences_table(const AccuracyResults& results, const Contract& contract) {
  Table table{"numbers that are not as promised", {}, {}};
  for (const char* name : {"outcome", "method", "change", "precision", "case"})
    table.columns.push_back({name, false});
  for (const char* name : {"difficulty", "what", "stated", "found"}) table.columns.push_back({name});
  for (const Outcome outcome : {Outcome::broken, Outcome::better}) {
    for (const AccuracyRecord& record : results.records()) {
      const Clause* const clause = contract.clause_of(record);
      for (const Judgement& one : judgements_of(record, contract)) {
        if (one.outcome != outcome) continue;
        table.rows.push_back({std::string(name_of(outcome)), record.method, record.change, record.precision,
                              record.case_id, fmt::format("{:g}", record.difficulty), std::string(one.what),
                              number_text(one, one.stated, clause->rays),
                              number_text(one, one.found, record.rays)});
      }
    }
  }
  return table;
}

}  // namespace raysweep
