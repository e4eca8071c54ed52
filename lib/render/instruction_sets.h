#pragma once

namespace candela {

// Whether this processor runs the kernels of an instruction set: those that lib/render/CMakeLists.txt
// compiles render/kernels_avx2.cpp and render/kernels_avx512.cpp for.

#if defined(__x86_64__)
inline bool runsAvx2Kernels() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
inline bool runsAvx512Kernels() {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
}
#endif

}  // namespace candela
