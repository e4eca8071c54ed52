#pragma once

#include <string>
#include <vector>

#include "gltf_file.h"

namespace candela_test {

/// A file in which every animated property is defined. Mesh 0 has two morph targets, and nodes 0 and 3 show
/// it; node 1 has light 0 and camera 0, node 2 light 1 and camera 1.
GltfFile fileOfEverything();

/// A JSON pointer to a property of such a file, and a value that it may have.
struct Pointed {
    std::string pointer;
    std::vector<float> value;
};
std::vector<Pointed> everyProperty();

/// The accessor type of so many numbers.
std::string typeOf(std::size_t components);

/// A channel to a pointer, of `sampler`.
std::string channelTo(const std::string& pointer, int sampler);

/// Adds an animation of one channel to a pointer, with the accessors `times` and `output`.
void animate(GltfFile& file, const std::string& pointer, int times, int output,
             const std::string& interpolation = "LINEAR");
/// The same with one key, at 0 s.
void animate(GltfFile& file, const Pointed& pointed);

}  // namespace candela_test
