#pragma once

#include "panels/frame_summary.h"

#include <glm/vec3.hpp>

#include <cstddef>

/// The colour of pass `index` of a `FrameSummary`: display code values.
glm::vec3 passColor(std::size_t index);

/// A bar for each stored frame, the latest at the right, with its passes on top of each other.
void drawFrameGraph(const std::deque<FrameRecord>& frames, const FrameSummary& summary);
