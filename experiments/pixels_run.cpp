#include "experiments/pixels_run.h"

#include <fmt/format.h>

#include <cctype>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "experiments/clock.h"
#include "experiments/errors.h"
#include "experiments/interrupt.h"
#include "experiments/peers/pictures.h"
#include "experiments/pixels_maker.h"
#include "experiments/progress.h"
#include "results/record.h"
#include "results/statistics/random.h"
#include "tracer/difference_pictures.h"
#include "tracer/scene/moved.h"

namespace raysweep {

namespace {

using CellRound = std::pair<std::string, int>;

std::set<CellRound> finished_rounds(const RunFiles& files) {
  std::set<CellRound> finished;
  if (!files.holds_records()) return finished;
  try {
    for (const PixelsRecord& r : read_pixels_records(files.records_file()))
      finished.insert({r.cell, r.round});
  } catch (const RecordError& error) {
    throw RequestError(error.what());
  }
  return finished;
}

/// A cell's key as the beginning of a file's name.
std::string file_name_of(std::string key) {
  for (char& c : key) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '+' && c != '_' && c != '.') c = '-';
  }
  return key;
}

/// A way to make the picture, and all that is known of it but the times.
struct Contender {
  PixelsMaker maker;
  PixelsRecord record;
  std::string hash;
};

class Picture {
 public:
  Picture(const PixelsExperiment& experiment, const PixelsGroup& group)
      : experiment_(experiment), group_(group) {
    const Mode& mode = picture_mode(group.mode);
    const Vec3d by(group.offset, group.offset, group.offset);
    const Scene scene = moved(lit_scene(group.scene_file, mode.lights), by);
    const RenderSettings usual = picture_settings(mode, experiment.config.settings.scale);
    RenderSettings settings = usual;
    const auto make = [&](const PixelsSubject& subject) {
      settings.core = subject.core;
      settings.method = subject.method;
      settings.precision = subject.precision;
      settings.pattern = subject.pattern.empty() ? usual.pattern : subject.pattern;
      settings.subpixels = subject.subpixels > 0 ? subject.subpixels : usual.subpixels;
      return PixelsMaker(scene, settings);
    };
    const int samples = experiment.config.settings.reference_subpixels;
    const PixelsMaker reference =
        make({"scalar", "woop_watertight", "double", samples > 0 ? "sobol" : "", samples});
    write(reference.film(), group_key(group), "reference");
    for (const PixelsSubject& subject : group.subjects) {
      contenders_.push_back({make(subject), record_of(subject, usual), {}});
      tell(contenders_.back(), reference);
    }
  }

  /// The records of the round, of the cells that are not among `finished`; numbered from `launch` on.
  std::vector<PixelsRecord> run_round(int round, uint64_t order_seed, int launch,
                                      const std::set<CellRound>& finished) {
    std::vector<PixelsRecord> records;
    Random random(order_seed);
    std::vector<Contender*> rest;
    for (Contender& contender : contenders_) rest.push_back(&contender);
    while (!rest.empty()) {
      const auto next = rest.begin() + static_cast<std::ptrdiff_t>(random.index(rest.size()));
      Contender& contender = **next;
      rest.erase(next);
      if (finished.contains({contender.record.cell, round})) continue;
      PixelsRecord record = contender.record;
      record.round = round;
      record.launch = launch++;
      time(contender, record);
      records.push_back(std::move(record));
    }
    return records;
  }

 private:
  [[nodiscard]] PixelsRecord record_of(const PixelsSubject& subject, const RenderSettings& usual) const {
    PixelsRecord record;
    record.experiment = experiment_.config.settings.experiment;
    record.cell = cell_key(group_, subject);
    record.seed = experiment_.config.settings.seed;
    record.scene = group_.scene;
    record.offset = group_.offset;
    record.mode = group_.mode;
    record.core = subject.core;
    record.method = subject.method;
    record.precision = subject.precision;
    record.pattern = subject.pattern.empty() ? usual.pattern : subject.pattern;
    record.subpixels = subject.subpixels > 0 ? subject.subpixels : usual.subpixels;
    const int of_reference = experiment_.config.settings.reference_subpixels;
    record.reference_subpixels = of_reference > 0 ? of_reference : usual.subpixels;
    return record;
  }

  void tell(Contender& contender, const PixelsMaker& reference) const {
    const Film& film = contender.maker.film();
    const FlipMap map = flip(film, reference.film());
    tell_errors(contender.record, contender.maker, reference, map);
    contender.hash = film.hash();
    if (contender.record.wrong_pixels == 0) return;
    // With other samples most edges are wrong a little: the picture itself shows how it looks.
    if (contender.record.subpixels == contender.record.reference_subpixels)
      write(wrong_pixels_picture(film, reference.film(), map), contender.record.cell, "wrong");
    else
      write(film, contender.record.cell, "picture");
    write(picture_of(map), contender.record.cell, "flip");
  }

  void write(const Film& film, const std::string& key, const char* what) const {
    const std::filesystem::path folder = experiment_.files->path() / "pictures";
    std::filesystem::create_directories(folder);
    write_png(film, (folder / fmt::format("{}-{}.png", file_name_of(key), what)).string());
  }

  /// Makes frames until their time is over, one at least.
  void time(Contender& contender, PixelsRecord& record) const {
    double sum = 0;
    do {
      record.seconds.push_back(contender.maker.frame());
      sum += record.seconds.back();
    } while (sum < experiment_.config.settings.seconds);
    record.valid = contender.maker.film().hash() == contender.hash;
    if (!record.valid) record.reason = "the last frame is not the picture that the first was";
  }

  const PixelsExperiment& experiment_;
  const PixelsGroup& group_;
  std::vector<Contender> contenders_;
};

std::string to_lines(const std::vector<PixelsRecord>& records) {
  std::string lines;
  for (const PixelsRecord& record : records) lines += to_line(record) + "\n";
  return lines;
}

bool lacks_any(const PixelsGroup& group, int rounds, const std::set<CellRound>& finished) {
  for (const PixelsSubject& subject : group.subjects) {
    for (int round = 0; round < rounds; ++round) {
      if (!finished.contains({cell_key(group, subject), round})) return true;
    }
  }
  return false;
}

}  // namespace

PixelsExperiment open_pixels(const PixelsConfig& config, const std::filesystem::path& folder,
                             const Machine& machine, bool resume) {
  const RunPapers papers{config.text, to_json(config)};
  return {config, std::make_unique<RunFiles>(folder, papers, machine, resume)};
}

PixelsReport run_pixels(const PixelsExperiment& experiment, bool quiet) {
  const PixelsConfig& config = experiment.config;
  const std::set<CellRound> finished = finished_rounds(*experiment.files);
  PixelsReport report;
  report.records = finished.size();
  const int total = static_cast<int>(config.cell_count()) * config.settings.rounds;
  Progress progress("frames' times", now_seconds(), std::numeric_limits<double>::infinity(), quiet);
  try {
    for (size_t i = 0; i < config.groups.size() && !report.was_interrupted; ++i) {
      const PixelsGroup& group = config.groups[i];
      if (!lacks_any(group, config.settings.rounds, finished)) continue;
      Picture picture(experiment, group);
      for (int round = 0; round < config.settings.rounds && !report.was_interrupted; ++round) {
        progress.show(static_cast<int>(report.records), total, now_seconds(),
                      fmt::format("{}, round {}", group_key(group), round));
        // By picture and round, so that a run that is taken up goes on as it would have gone.
        const uint64_t order_seed = config.settings.seed + 1'000'003 * i + static_cast<uint64_t>(round);
        const auto records = picture.run_round(round, order_seed, static_cast<int>(report.records), finished);
        if (!records.empty()) experiment.files->append_text(to_lines(records), "rounds");
        report.records += records.size();
        for (const PixelsRecord& record : records) report.void_records += !record.valid;
        report.was_interrupted = interrupted() && report.records < static_cast<size_t>(total);
      }
    }
  } catch (const std::runtime_error& error) {
    report.failure = error.what();
  }
  return report;
}

}  // namespace raysweep
