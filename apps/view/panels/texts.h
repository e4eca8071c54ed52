#pragma once

#include <cstdint>
#include <string>

/// Such as "1,234,567".
std::string groupedText(std::uint64_t number);

/// Such as "512 B", "1.5 KiB", "20.0 MiB", "3.2 GiB".
std::string bytesText(std::uint64_t bytes);

/// Such as "material 3 brass"; "material 3" where there is no name.
std::string elementText(const char* kind, std::uint64_t index, const std::string& name);

/// `path` with `ending` (such as ".png") added, unless it has it.
std::string withEnding(const std::string& path, const std::string& ending);
