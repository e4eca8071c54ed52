#pragma once

#include <candela/color.h>
#include <candela/gpu_scene.h>
#include <candela/renderer.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// A frame as `display` shows it, into an 8-bit PNG; black where nothing is, never see-through. The
/// file is whole or absent, also when a signal ends the program.
void writeShownPicture(const std::filesystem::path& path, int width, int height,
                       std::vector<std::uint8_t> rgba, const candela::DisplayTransform& display);

/// A frame's radiance and the AOVs of these names, into an EXR; whole or absent likewise.
void writeRadiance(const std::filesystem::path& path, const candela::Frame& frame, const std::vector<std::string>& aovs,
                   const candela::ColorConfig& color);
