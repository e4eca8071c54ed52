#pragma once

/// shaders/shared/shading.h and what it includes; the definition is written by CMake.
extern const char* const shadingSource;
