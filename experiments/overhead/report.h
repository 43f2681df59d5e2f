// Tables of one program, printed and written.
#pragma once

#include <string>
#include <vector>

#include "experiments/machine/machine.h"
#include "results/tables/table.h"

namespace raysweep {

/// A table for people, and the same as numbers; without columns it is one for machines alone.
struct ReportPart {
  std::string name;         // of its file of numbers, without ".csv"
  std::string explanation;  // what the columns say, in a paragraph
  Table table, numbers;
};

struct Report {
  std::string name, title;  // the name of its Markdown file, without ".md"; its heading
  std::vector<ReportPart> parts;
};

/// "host: cpu, 2 cores, 2 processors; Linux 6.1; gcc 12.2.0; load 0.4".
[[nodiscard]] std::string machine_line(const Machine& machine);

void print_report(const Report& report, const Machine& machine);

/// Makes the folder. Throws RequestError if there can be none; to be called before anything is measured.
void make_report_folder(const std::string& folder);

/// NAME.md and a CSV file for each part. Throws WorkError if one cannot be written.
void write_report(const Report& report, const Machine& machine, const std::string& folder);

}  // namespace raysweep
