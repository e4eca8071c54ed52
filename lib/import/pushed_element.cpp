#include "import/pushed_element.h"

#include <candela/error.h>

#include <cmath>

namespace candela {
namespace {

constexpr std::size_t longestNameShown = 80;

}  // namespace

PushedElement::PushedElement(const char* kind, std::size_t index, const char* name)
    : kind_(kind), index_(index), name_(validUtf8(name)) {}

std::string PushedElement::label() const {
    if (name_.empty()) return joined(kind_, " ", index_);
    return joined(kind_, " ", index_, " '", oneLine(name_, longestNameShown), "'");
}

void PushedElement::refuse(const std::string& text) const {
    throw Error(ErrorKind::badInput, "", label() + ": " + text);
}

float PushedElement::finite(const char* member, float value) const {
    if (!std::isfinite(value)) refuse(joined(member, " is ", value, ", but a finite number was expected"));
    return value;
}

glm::vec3 PushedElement::finiteVector(const char* member, const float (&from)[3]) const {
    return {finite(member, from[0]), finite(member, from[1]), finite(member, from[2])};
}

float PushedElement::within(const char* member, float value, float low, float high) const {
    finite(member, value);
    if (value < low || value > high)
        refuse(joined(member, " is ", value, ", but ", low, " to ", high, " was expected"));
    return value;
}

float PushedElement::zeroOrMore(const char* member, float value) const {
    finite(member, value);
    if (value < 0.0f) refuse(joined(member, " is ", value, ", but 0 or more was expected"));
    return value;
}

bool PushedElement::flag(const char* member, std::uint32_t value) const {
    if (value > 1) refuse(joined(member, " is ", value, ", but 0 or 1 was expected"));
    return value == 1;
}

std::optional<std::uint32_t> PushedElement::reference(const char* member, std::int32_t index,
                                                      std::size_t count) const {
    if (index == -1) return std::nullopt;
    if (index < 0 || static_cast<std::size_t>(index) >= count)
        refuse(joined(member, " is ", index, ", but ", count, " were pushed so far and -1 is none"));
    return static_cast<std::uint32_t>(index);
}

void PushedElement::requireFinite(const char* member, const float* numbers, std::size_t count,
                                  std::size_t components) const {
    for (std::size_t i = 0; i < count * components; ++i)
        if (!std::isfinite(numbers[i]))
            refuse(joined(member, " ", i / components, " has the component ", numbers[i],
                          ", but finite numbers were expected"));
}

}  // namespace candela
