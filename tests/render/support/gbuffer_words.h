#pragma once

#include "render/gbuffer/gbuffer_copy.h"
#include "render/gbuffer/readback.h"

#include <cstdint>
#include <vector>

namespace candela::test {

/// What the geometry pass has written, to compare bit for bit.
struct GBufferWords {
    std::vector<std::uint32_t> surfaces;
    std::vector<float> depth, radiance;
    bool operator==(const GBufferWords&) const = default;
};

inline GBufferWords wordsOf(const GBufferTargets& targets) {
    GBufferCopy copy;
    copy.reset(targets);
    return {{copy.surfaces().begin(), copy.surfaces().end()},
            {copy.depth().begin(), copy.depth().end()},
            readColor(targets.radiance, targets.width, targets.height)};
}

}  // namespace candela::test
