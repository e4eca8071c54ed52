#pragma once

#include <glm/vec2.hpp>

#include <filesystem>

/// Writes what the window shows with its next swap, panels included, as a PNG. `size` is that of its
/// framebuffer. Throws `candela::Error`.
void writeWindowPicture(const std::filesystem::path& file, const glm::ivec2& size);
