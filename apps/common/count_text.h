#pragma once

#include <cstdint>
#include <string>

/// Such as "1,234,567".
std::string groupedText(std::uint64_t number);

/// Such as "1 light" and "1,234 lights"; `many` where the plural is not formed by an s.
std::string countText(std::uint64_t number, const char* one, const char* many = nullptr);
