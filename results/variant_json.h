// How records of every kind write a variant.
#pragma once

#include <nlohmann/json.hpp>

#include "results/accuracy_record.h"

namespace raysweep {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(VariantRecord, division, reciprocal, order, edges, early_out, output, data)

}  // namespace raysweep
