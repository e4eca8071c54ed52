#include "render/instruction_sets.h"

#include <candela/error.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

namespace candela {

namespace {

constexpr const char* variable = "CANDELA_INSTRUCTION_SET";
constexpr std::array<std::string_view, 3> names{"baseline", "avx2", "avx512"};

InstructionSet widestOfProcessor() {
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return InstructionSet::baseline;
    const bool isWide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
    return isWide ? InstructionSet::avx512 : InstructionSet::avx2;
#else
    return InstructionSet::baseline;
#endif
}

InstructionSet findWidest() {
    const InstructionSet widest = widestOfProcessor();
    const char* text = std::getenv(variable);
    if (text == nullptr || *text == '\0') return widest;
    const auto name = std::ranges::find(names, text);
    const auto set = static_cast<InstructionSet>(name - names.begin());
    if (name != names.end() && set <= widest) return set;
    std::string expected = "\"baseline\"";
    for (auto other = InstructionSet::avx2; other <= widest;
         other = static_cast<InstructionSet>(static_cast<int>(other) + 1))
        expected += ", \"" + std::string(names[static_cast<std::size_t>(other)]) + "\"";
    const char* what =
        name == names.end() ? " names no instruction set" : " is more than this processor runs";
    throw Error(ErrorKind::environment, variable,
                "\"" + std::string(text) + "\"" + what + "; expected " + expected);
}

}  // namespace

InstructionSet widestInstructionSet() {
    static const InstructionSet widest = findWidest();
    return widest;
}

}  // namespace candela
