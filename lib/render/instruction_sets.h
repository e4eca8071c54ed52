#pragma once

namespace candela {

/// What the vector kernels are compiled for, from the narrowest: `lib/render/CMakeLists.txt` has the
/// compiler's options of each. Processors other than x86-64 run `baseline` alone.
enum class InstructionSet { baseline, avx2, avx512 };

/// The widest that this processor runs, or the narrower one that `CANDELA_INSTRUCTION_SET` names in the
/// environment: `baseline`, `avx2` or `avx512`. Throws `Error` (environment) where it names none, or one that
/// this processor lacks.
InstructionSet widestInstructionSet();

}  // namespace candela
