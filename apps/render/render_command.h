#pragma once

#include "options.h"

/// Reads the scene, draws its frames and writes them. Throws `candela::Error`; frames finished before stay.
void renderPictures(const Options& options);
