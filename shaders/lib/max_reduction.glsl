// The greatest value of a picture, as greatest.comp finds it. Bits of floats of 0 and more are in the order of the floats.

#include "shared/bindings.h"

layout(std430, binding = MAX_REDUCTION_STORAGE) buffer MaxReductionBlock { uint greatest; };
