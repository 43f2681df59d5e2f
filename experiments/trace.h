// A timeline of chunks for a trace viewer.
#pragma once

#include <string>

#include "experiments/render_job.h"

namespace raysweep {

/// Writes what the job's workers did, chunk by chunk, as a Chrome trace (the Trace Event Format's JSON),
/// which Perfetto (ui.perfetto.dev) and chrome://tracing open: a row for the frames and one for each worker.
/// The job must have been reset with LogDetail::events. Throws std::runtime_error if the file cannot be
/// written.
void write_trace(const Cell& cell, const RenderJob& job, const std::string& path);

}  // namespace raysweep
