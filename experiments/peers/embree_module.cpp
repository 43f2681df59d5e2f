// The module that brings Embree.
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <array>

#include "experiments/clock.h"
#include "experiments/errors.h"
#include "experiments/peers/embree_team.h"
#include "tracer/peers/embree_rays.h"
#include "tracer/peers/embree_renderer.h"

namespace raysweep {

namespace {

class EmbreeContestant final : public Contestant {
 public:
  EmbreeContestant(std::string name, std::shared_ptr<const EmbreeScene> scene,
                   std::shared_ptr<EmbreeRays> rays, bool coherent)
      : name_(std::move(name)), scene_(std::move(scene)), rays_(std::move(rays)), coherent_(coherent) {}

  [[nodiscard]] std::string name() const override { return name_; }
  void prepare(const RayBatch& rays, bool any_hit) override { rays_->prepare(rays, any_hit); }
  void reset() override { rays_->reset(); }
  void run() override { rays_->trace(*scene_, coherent_); }
  [[nodiscard]] HitBatch hits() const override { return rays_->hits(*scene_); }

 private:
  std::string name_;
  std::shared_ptr<const EmbreeScene> scene_;
  std::shared_ptr<EmbreeRays> rays_;  // shared by all of one width, who run one after the other
  bool coherent_;
};

BuildCost timed_build(const Scene& scene, const EmbreeBuild& how) {
  EmbreeScene built(how);
  const double begin = now_seconds();
  built.build(scene);
  return {now_seconds() - begin, built.bytes()};
}

/// Of the instruction sets that Embree 3 has code for, the two best, as far as this processor has them.
std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (const char* name : {"avx2", "avx512"}) {
    try {
      const EmbreeScene probe({name});
      names.emplace_back(name);
    } catch (const EmbreeError&) {
      continue;
    }
  }
  if (names.empty())
    throw RequestError("peers: Embree is compared on AVX2 and AVX-512; this processor has neither");
  return names;
}

constexpr std::array widths{1, 4, 8, 16};

class TeamMaker {
 public:
  explicit TeamMaker(const Scene& scene) : scene_(scene) {
    for (size_t i = 0; i < widths.size(); ++i) rays_[i] = make_embree_rays(widths[i]);
  }

  void add(const EmbreeBuild& how) {
    const auto built = std::make_shared<EmbreeScene>(how);
    built->build(scene_);
    if (!how.robust) add_builds(how);
    for (size_t i = 0; i < widths.size(); ++i) {
      for (const bool coherent : {true, false}) {
        const std::string width = widths[i] == 1 ? "single" : std::to_string(widths[i]);
        std::string name = how.name() + " " + width + (coherent ? " coherent" : " incoherent");
        const bool single = widths[i] == 1 && !how.high_quality;
        team_.entrants.push_back(
            {std::make_unique<EmbreeContestant>(std::move(name), built, rays_[i], coherent), single,
             how.robust});
      }
    }
  }

  [[nodiscard]] Team team() { return std::move(team_); }

 private:
  void add_builds(EmbreeBuild how) {
    for (const int threads : build_threads) {
      how.threads = threads;
      team_.builds.push_back({how.high_quality ? "high" : "medium", threads,
                              [&scene = scene_, how] { return timed_build(scene, how); }});
    }
  }

  const Scene& scene_;
  std::array<std::shared_ptr<EmbreeRays>, widths.size()> rays_;
  Team team_;
};

Team make_team(const Scene& scene, bool robust) {
  TeamMaker maker(scene);
  for (const std::string& isa : instruction_sets()) {
    for (const bool high : {false, true}) {
      maker.add({.isa = isa, .high_quality = high});
      if (robust) maker.add({.isa = isa, .high_quality = high, .robust = true});
    }
  }
  return maker.team();
}

/// Primary and shadow rays go in packets as wide as the instructions, which have always been fastest, told to
/// be coherent; for mirrored ones it depends on the scene.
class Pictures final : public EmbreePictures {
 public:
  explicit Pictures(const Scene& scene) : shapes_(std::make_shared<const EmbreeShapes>(scene)) {
    for (const std::string& isa : instruction_sets()) {
      for (const bool high : {false, true}) {
        const EmbreeBuild how{isa, high, false};
        const auto built = std::make_shared<EmbreeScene>(how);
        built->build(scene);
        const EmbreePackets widest{isa == "avx512" ? 16u : 8u, true};
        for (const EmbreePackets& mirrored : {widest, EmbreePackets{8, false}, EmbreePackets{1, false}})
          ways_.push_back({how.name(), built, {widest, widest, mirrored}});
      }
    }
  }

  [[nodiscard]] std::vector<std::string> ways() const override {
    std::vector<std::string> names;
    for (const Way& way : ways_) {
      const EmbreePackets& mirrored = way.modes.mirrored;
      names.push_back(way.build + " " + std::to_string(way.modes.primary.width) + " coherent, mirrored " +
                      (mirrored.width == 1 ? "single" : std::to_string(mirrored.width)) +
                      (mirrored.coherent ? " coherent" : " incoherent"));
    }
    return names;
  }

  [[nodiscard]] std::unique_ptr<const Renderer> make_renderer(const Scene& scene,
                                                              const RenderSettings& settings,
                                                              size_t way) const override {
    return make_embree_renderer(scene, settings,
                                {shapes_, ways_.at(way).triangles, ways_.at(way).modes, now_seconds});
  }

  [[nodiscard]] double seconds_inside(const Workspace& workspace) const override {
    return seconds_in_embree(workspace);
  }

 private:
  struct Way {
    std::string build;
    std::shared_ptr<const EmbreeScene> triangles;
    EmbreeModes modes;
  };

  std::shared_ptr<const EmbreeShapes> shapes_;
  std::vector<Way> ways_;
};

std::unique_ptr<EmbreePictures> make_pictures(const Scene& scene) {
  return std::make_unique<Pictures>(scene);
}

ForEach share_by_tbb(int threads) {
  // Devices limit TBB in the whole process to the threads of the last one that was made.
  const auto device =
      std::make_shared<const EmbreeScene>(EmbreeBuild{.isa = instruction_sets().front(), .threads = threads});
  const auto arena = std::make_shared<tbb::task_arena>(threads);
  arena->initialize();
  return [device, arena](size_t count, const std::function<void(size_t)>& body) {
    arena->execute([&] { tbb::parallel_for(size_t{0}, count, body, tbb::simple_partitioner()); });
  };
}

}  // namespace

}  // namespace raysweep

extern "C" [[gnu::visibility("default")]] const raysweep::EmbreeModule* raysweep_embree_module() {
  static const raysweep::EmbreeModule module{raysweep::embree_layout,           raysweep::embree_version(),
                                             raysweep::embree_has_assertions(), raysweep::make_team,
                                             raysweep::make_pictures,           raysweep::share_by_tbb};
  return &module;
}
