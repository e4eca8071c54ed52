#include "module.h"
#include "scene_data.h"
#include "words.h"

namespace candela::python {

template <>
struct Convert<AnimationChannel> : ConvertClass<AnimationChannel> {};
template <>
struct Convert<PropertyChannel> : ConvertClass<PropertyChannel> {};

template <>
const Record<AnimationChannel>& recordOf<AnimationChannel>() {
    static const Record<AnimationChannel> record =
        Record<AnimationChannel>("AnimationChannel")
            .field("node", &AnimationChannel::node, "Index into `Scene.nodes`.")
            .field("path", &AnimationChannel::path, "What changes.")
            .field("interpolation", &AnimationChannel::interpolation, "Between keys.")
            .field("times", &AnimationChannel::times, "Seconds, strictly increasing, (K,).")
            .field("values", &AnimationChannel::values,
                   "3 numbers for each key, 4 (x, y, z, w) for rotations, 1 or one for each morph target for "
                   "morph weights, flat; three times as many for 'cubic_spline': in-tangent, value, "
                   "out-tangent.")
            .field("morph_target", &AnimationChannel::morphTarget, "The only target whose weight changes.");
    return record;
}

template <>
const Record<PropertyChannel>& recordOf<PropertyChannel>() {
    static const Record<PropertyChannel> record =
        Record<PropertyChannel>("PropertyChannel")
            .field("attribute", &PropertyChannel::property,
                   "What changes: the attribute of that name of a node, a material or a camera; "
                   "'texture_...' of a texture of a material, 'light_...' and the cone angles of a light.")
            .field("element", &PropertyChannel::element,
                   "Whose: index into `Scene.nodes`, `materials`, `lights` or `cameras`, by the attribute.")
            .field("texture", &PropertyChannel::texture,
                   "Of textures: which one of the material, which has it.")
            .field("interpolation", &PropertyChannel::interpolation,
                   "Between keys; of 'visible' it is 'step', with 0 and 1.")
            .field("times", &PropertyChannel::times, "Seconds, strictly increasing, (K,).")
            .field("values", &PropertyChannel::values,
                   "So many numbers for each key as a value has, flat, in the unit and the range of the "
                   "attribute: 1, 2 (texture_offset, texture_scale), 3 (colours) or 4 (base_color); three "
                   "times as many for 'cubic_spline': in-tangent, value, out-tangent.");
    return record;
}

template <>
const Record<Animation>& recordOf<Animation>() {
    static const Record<Animation> record =
        Record<Animation>("Animation")
            .field("name", &Animation::name, "The animation's name.")
            .field("channels", &Animation::channels, "What it moves.")
            .field("properties", &Animation::properties,
                   "What it changes of nodes' visibility, materials, lights and cameras.")
            .field("plays", &Animation::plays, "False: the scene is posed as if it were not there.");
    return record;
}

void bindAnimations(nb::module_& module) {
    bindValue<AnimationChannel>(module, "The transform of one node, or its morph weights, over time.");
    bindValue<PropertyChannel>(module,
                               "A value of a node, a material, a light or a camera over time "
                               "(KHR_animation_pointer).");
    bindElement<Animation>(module, "Channels that play together.");
}

}  // namespace candela::python
