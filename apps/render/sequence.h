#pragma once

#include "frame_writer.h"
#include "picture_plan.h"
#include "posing.h"
#include "run_notes.h"
#include "run_report.h"

#include <candela/color.h>
#include <candela/scene.h>

#include <cstdint>
#include <optional>
#include <vector>

/// What pictures are drawn of and with; all have to outlive a `Sequence`.
struct SequenceSource {
    const Options& options;
    const candela::Scene& scene;
    const candela::ColorConfig& color;
    const PicturePlan& plan;
    FrameWriter& writer;
    Lighting& lighting;
    RunReport& report;
};

/// What a run of pictures came to.
struct SequenceResult {
    int signal = 0;  ///< That ended it early; 0 without one.
    std::vector<FrameTiming> timings;
};

/// Whether a picture need not be drawn: --skip-existing, and it is there.
bool isSkipped(const Options& options, const PlannedPicture& picture);

/// Draws the pictures of the plan one after the other and encodes and writes each beside the drawing of the
/// next ones, on threads of their own. Notes what a user should know of them. The first failure ends the run
/// after the pictures before it, and is thrown; with --keep-going it is reported, the others are drawn, and
/// an error at the end names all that failed.
SequenceResult drawSequence(const SequenceSource& source);
