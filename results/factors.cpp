#include "results/factors.h"

namespace raysweep {

const std::vector<FactorText>& factor_texts() {
  static const std::vector<FactorText> list{
      {"scene", [](const Record& r) { return r.scene; }, false},
      {"mode", [](const Record& r) { return r.mode; }, false},
      {"width", [](const Record& r) { return std::to_string(r.width); }, true},
      {"height", [](const Record& r) { return std::to_string(r.height); }, true},
      {"subpixels", [](const Record& r) { return std::to_string(r.subpixels); }, true},
      {"pattern", [](const Record& r) { return r.pattern; }, false},
      {"depth", [](const Record& r) { return std::to_string(r.depth); }, true},
      {"lights", [](const Record& r) { return std::to_string(r.lights); }, true},
      {"core", [](const Record& r) { return r.core; }, false},
      {"method", [](const Record& r) { return r.method; }, false},
      {"precision", [](const Record& r) { return r.precision; }, false},
      {"accel", [](const Record& r) { return r.accel; }, false},
      {"leaf", [](const Record& r) { return std::to_string(r.leaf); }, true},
      {"item", [](const Record& r) { return r.item; }, false},
      {"pin", [](const Record& r) { return r.pin; }, false},
      {"scheduler", [](const Record& r) { return r.scheduler; }, false},
      {"chunk", [](const Record& r) { return r.chunk; }, true},
      {"threads", [](const Record& r) { return std::to_string(r.threads); }, true},
  };
  return list;
}

}  // namespace raysweep
