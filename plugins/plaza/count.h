#pragma once

#include <cstdint>
#include <string>

namespace plaza {

/// Reads a whole number from 0 to 16,000,000 written in digits alone. Throws `BadRequest` that names
/// `element` and shows `example` when `text` is anything else.
std::uint32_t parseCount(const std::string& text, const std::string& element, const std::string& example);

}  // namespace plaza
