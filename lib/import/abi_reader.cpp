#include "import/abi_reader.h"

#include <candela/error.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace candela {

namespace {

// The tolerance for matrices that were written as text or multiplied in single precision.
constexpr float affineTolerance = 1e-5f;

}  // namespace

std::size_t copyIndices(const std::uint32_t* from, std::size_t count, std::size_t end,
                        std::vector<std::uint32_t>& out) {
    // The maximum is found without a branch for each index: there may be many millions.
    std::uint32_t maximum = 0;
    copyInBlocks(from, count, out, [&maximum](const std::uint32_t* block, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i) maximum = std::max(maximum, block[i]);
    });
    if (count == 0 || maximum < end) return count;
    const auto beyond = std::ranges::find_if(out, [end](std::uint32_t index) { return index >= end; });
    return static_cast<std::size_t>(beyond - out.begin());
}

AbiReader::AbiReader(const char* kind, std::optional<std::size_t> index, const char* name)
    : kind_(kind), index_(index), name_(validUtf8(name)) {}

ErrorContext AbiReader::context() const {
    return {kind_, index_, name_};
}

std::string AbiReader::label() const {
    return context().label();
}

void AbiReader::refuse(const std::string& text) const {
    context().refuse(text);
}

float AbiReader::finite(const char* member, float value) const {
    if (!std::isfinite(value)) refuse(joined(member, " is ", value, ", but a finite number was expected"));
    return value;
}

glm::vec3 AbiReader::finiteVector(const char* member, const float (&from)[3]) const {
    return {finite(member, from[0]), finite(member, from[1]), finite(member, from[2])};
}

float AbiReader::within(const char* member, float value, float low, float high) const {
    context().requireWithin(member, value, low, high);
    return value;
}

float AbiReader::zeroOrMore(const char* member, float value) const {
    context().requireNotNegative(member, value);
    return value;
}

std::uint32_t AbiReader::below(const char* member, std::uint32_t value, std::uint32_t end) const {
    if (value >= end && end == 0) refuse(joined(member, " is ", value, ", but there are none"));
    if (value >= end) refuse(joined(member, " is ", value, ", but 0 to ", end - 1, " was expected"));
    return value;
}

bool AbiReader::flag(const char* member, std::uint32_t value) const {
    if (value > 1) refuse(joined(member, " is ", value, ", but 0 or 1 was expected"));
    return value == 1;
}

void AbiReader::present(const char* member, const void* array, std::size_t count) const {
    if (count > 0 && !array) refuse(joined(member, " is NULL, but ", count, " elements were expected"));
}

void AbiReader::counts(const char* member, const std::uint32_t* from, std::size_t count,
                       std::vector<std::uint32_t>& out) const {
    present(member, from, count);
    reserveLarge(out, count);
    out.insert(out.end(), from, from + count);
}

glm::mat4 AbiReader::affine(const std::string& member, glm::mat4 matrix) const {
    for (int column = 0; column < 4; ++column) {
        const float expected = column == 3 ? 1.0f : 0.0f;
        float& last = matrix[column][3];
        if (std::abs(last - expected) > affineTolerance)
            refuse(joined(member, " is not affine: the last number of column ", column, " is ", last,
                          ", but ", expected, " was expected"));
        last = expected;
    }
    return matrix;
}

glm::quat AbiReader::unitQuaternion(const char* member, const float (&xyzw)[4]) const {
    // The error of 8-bit quantised quaternions, sqrt(4) × 0.5 / 127 = 0.0079, rounded up.
    constexpr double tolerance = 0.01;
    double square = 0.0;
    for (const float number : xyzw) square += double{finite(member, number)} * number;
    const double length = std::sqrt(square);
    if (std::abs(length - 1.0) > tolerance)
        refuse(joined(member, " has the length ", length, ", but a unit quaternion was expected"));
    const auto part = [&](int i) { return static_cast<float>(xyzw[i] / length); };
    return {part(3), part(0), part(1), part(2)};
}

std::optional<std::uint32_t> AbiReader::reference(const char* member, std::int32_t index,
                                                  std::size_t count) const {
    if (index == -1) return std::nullopt;
    if (index < 0 || static_cast<std::size_t>(index) >= count)
        refuse(joined(member, " is ", index, ", but ", count, " were added so far and -1 is none"));
    return static_cast<std::uint32_t>(index);
}

// Without a branch for each number, so that the compiler vectorises it: the tables of a subdivider have many
// millions of numbers.
bool AbiReader::allAreFinite(const float* numbers, std::size_t count) {
    constexpr std::uint32_t exponent = 0x7F800000;
    std::uint32_t broken = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto bits = std::bit_cast<std::uint32_t>(numbers[i]);
        broken |= (bits & exponent) == exponent ? 1u : 0u;
    }
    return broken == 0;
}

void AbiReader::requireFinite(const char* member, const float* numbers, std::size_t count,
                              std::size_t components) const {
    const auto broken = std::find_if_not(numbers, numbers + count * components,
                                         [](float number) { return std::isfinite(number); });
    refuse(joined(member, " ", static_cast<std::size_t>(broken - numbers) / components, " has the component ",
                  *broken, ", but finite numbers were expected"));
}

}  // namespace candela
