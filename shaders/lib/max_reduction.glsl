// The largest value of a texture, found by max_reduction.comp, as the bits of a float: those of floats of 0 and more are in the order of
// the floats.

#include "shared/bindings.h"

layout(std430, binding = MAX_REDUCTION_STORAGE) buffer MaxReductionBlock {
    uint maximumBits;
};
