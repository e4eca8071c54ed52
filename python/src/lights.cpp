#include "scene_types.h"
#include "words.h"

namespace candela::python {

namespace {

// One value for all, or one for each of `count`.
std::vector<float> numbersOf(nb::handle value, std::size_t count, const std::string& name) {
    const nb::object array =
        nb::module_::import_("numpy").attr("asarray")(value, nb::arg("dtype") = "float32");
    const int dimensions = nb::cast<int>(array.attr("ndim"));
    if (dimensions == 0) return {nb::cast<float>(array.attr("item")())};
    std::vector<float> numbers = floatsFrom(array, 0, name);
    if (numbers.size() != count)
        failConversion(name, "a number, or " + std::to_string(count) + " numbers, one for each light", array);
    return numbers;
}

std::vector<glm::vec3> vectorsOf(nb::handle value, std::size_t count, const std::string& name) {
    const nb::object array =
        nb::module_::import_("numpy").attr("asarray")(value, nb::arg("dtype") = "float32");
    if (nb::cast<int>(array.attr("ndim")) == 1) return {Convert<glm::vec3>::from(array, name)};
    std::vector<glm::vec3> vectors = vectorsFrom<3>(array, name);
    if (vectors.size() != count)
        failConversion(name, "(3,), or (" + std::to_string(count) + ", 3) with a row for each light", array);
    return vectors;
}

template <typename V>
const V& valueOf(const std::vector<V>& values, std::size_t index) {
    return values.size() == 1 ? values.front() : values[index];
}

}  // namespace

const char* LightArrays::keywords() {
    return ", *, color: numpy.typing.ArrayLike = (1, 1, 1), intensity: numpy.typing.ArrayLike = 1.0, "
           "range: numpy.typing.ArrayLike | None = None, radius: numpy.typing.ArrayLike = 0.0, "
           "direction: numpy.typing.ArrayLike = (0, 0, -1), "
           "type: typing.Literal['point', 'spot', 'directional'] = 'point', inner_cone_angle: float = 0.0, "
           "outer_cone_angle: float = 0.785398, casts_shadow: bool = True";
}

LightArrays::LightArrays(nb::handle positions, const nb::kwargs& options) {
    if (!positions.is_none()) positions_ = vectorsFrom<3>(positions, "positions of lights");
    size_ = positions_.size();
    if (positions.is_none() && options.contains("direction")) {
        directions_ = vectorsFrom<3>(options["direction"], "direction of lights");
        size_ = directions_.size();
    }
    for (const auto& [name, value] : options) read(nb::str(name).c_str(), value);
    if (positions.is_none() && common_.type != LightType::directional)
        throw Error(ErrorKind::badInput, "", "lights: only directional lights have no positions");
}

void LightArrays::read(const std::string& name, nb::handle value) {
    const std::string place = name + " of lights";
    if (name == "color") {
        colors_ = vectorsOf(value, size_, place);
    } else if (name == "intensity") {
        intensities_ = numbersOf(value, size_, place);
    } else if (name == "range") {
        if (!value.is_none()) ranges_ = numbersOf(value, size_, place);
    } else if (name == "radius") {
        radii_ = numbersOf(value, size_, place);
    } else if (name == "direction") {
        if (directions_.empty()) directions_ = vectorsOf(value, size_, place);
        for (glm::vec3& direction : directions_) {
            const float length = glm::length(direction);
            if (!(length > 0.0f)) throw Error(ErrorKind::badInput, "", place + ": a direction has no length");
            direction /= length;
        }
    } else if (name == "type") {
        common_.type = Convert<LightType>::from(value, place);
    } else if (name == "inner_cone_angle") {
        common_.innerConeAngle = Convert<float>::from(value, place);
    } else if (name == "outer_cone_angle") {
        common_.outerConeAngle = Convert<float>::from(value, place);
    } else if (name == "casts_shadow") {
        common_.castsShadow = Convert<bool>::from(value, place);
    } else {
        throw nb::type_error(("lights have no '" + name + "'").c_str());
    }
}

Light LightArrays::light(std::size_t index) const {
    Light light = common_;
    if (!positions_.empty()) light.position = positions_[index];
    if (!directions_.empty()) light.direction = valueOf(directions_, index);
    if (!colors_.empty()) light.color = valueOf(colors_, index);
    if (!intensities_.empty()) light.intensity = valueOf(intensities_, index);
    if (!ranges_.empty()) light.range = valueOf(ranges_, index);
    if (!radii_.empty()) light.radius = valueOf(radii_, index);
    return light;
}

WorldLight LightArrays::worldLight(std::size_t index) const {
    const Light light = this->light(index);
    WorldLight world;
    world.type = light.type;
    world.position = light.position;
    world.range = light.range.value_or(0.0f);
    world.direction = light.direction;
    world.intensity = light.color * light.intensity;
    world.innerConeAngle = light.innerConeAngle;
    world.outerConeAngle = light.outerConeAngle;
    world.castsShadow = light.castsShadow;
    world.radius = light.radius;
    return world;
}

}  // namespace candela::python
