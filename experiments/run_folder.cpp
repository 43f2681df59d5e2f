#include "experiments/run_folder.h"

#include "experiments/errors.h"

namespace raysweep {

RunFolder::RunFolder(std::filesystem::path path, const Config& config, const Plan& plan,
                     const Machine& machine, bool resume)
    : files_(std::move(path), {config.text, to_json(plan)}, machine, resume) {
  if (!files_.holds_records()) return;
  try {
    records_ = read_records(files_.records_file());
  } catch (const RecordError& error) {
    throw RequestError(error.what());
  }
}

void RunFolder::append(const Record& record) {
  files_.append_text(to_line(record) + "\n", "launches");
  records_.push_back(record);
}

}  // namespace raysweep
