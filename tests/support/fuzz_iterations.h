#pragma once

#include <cstdlib>

namespace candela_test {

/// How many inputs a fuzz test tries: `count`, times CANDELA_FUZZ_FACTOR where the environment sets it, for
/// long runs.
template <typename Count>
Count fuzzIterations(Count count) {
    const char* factor = std::getenv("CANDELA_FUZZ_FACTOR");
    return factor == nullptr ? count : count * static_cast<Count>(std::atoi(factor));
}

}  // namespace candela_test
