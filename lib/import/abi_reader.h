#pragma once

#include "base/error_context.h"
#include "base/large_pages.h"
#include "import/plugin_abi.h"
#include "import/text.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// Copies indices. Returns the place of the first that is not below `end`; `count` where all are.
std::size_t copyIndices(const std::uint32_t* from, std::size_t count, std::size_t end,
                        std::vector<std::uint32_t>& out);

/// Reads the members of an element that a plugin adds ("mesh 3 'wheel'"), with the checks that every kind of
/// element needs. A failed check throws `Error` (badInput) without a path; its text begins with the element.
class AbiReader {
  public:
    /// Without an index the label is "cage 'body'".
    AbiReader(const char* kind, std::optional<std::size_t> index, const char* name);

    /// As errors name the element. Valid as long as this.
    ErrorContext context() const;
    std::string label() const;
    /// The element's name as valid UTF-8.
    const std::string& name() const { return name_; }

    [[noreturn]] void refuse(const std::string& text) const;

    float finite(const char* member, float value) const;
    glm::vec3 finiteVector(const char* member, const float (&from)[3]) const;
    /// `value` has to be finite and in low..high, both included.
    float within(const char* member, float value, float low, float high) const;
    float zeroOrMore(const char* member, float value) const;

    /// The array must not be NULL unless `count` is 0.
    void present(const char* member, const void* array, std::size_t count) const;

    /// Copies `count` elements of `components` numbers each into `out`, whose elements hold just these. The
    /// array has to be present, and all its numbers finite.
    template <class T>
    void numbers(const char* member, const float* from, std::size_t count, std::vector<T>& out) const {
        present(member, from, count);
        if (count == 0) return;
        bool finite = true;
        copyInBlocks(from, count, out, [&finite](const float* block, std::size_t size) {
            finite = finite && allAreFinite(block, size);
        });
        constexpr std::size_t components = sizeof(T) / sizeof(float);
        if (!finite) requireFinite(member, reinterpret_cast<const float*>(out.data()), count, components);
    }

    /// Copies `count` numbers of an array that has to be present.
    void counts(const char* member, const std::uint32_t* from, std::size_t count,
                std::vector<std::uint32_t>& out) const;

    /// The number of an enumerator, which has to be below `count`.
    template <class Enum>
    std::uint32_t enumerator(const char* member, const Enum& value, std::uint32_t count) const {
        const std::uint32_t number = numberOf(value);
        if (number >= count)
            refuse(joined(member, " is ", static_cast<std::int32_t>(number), ", but 0 to ", count - 1,
                          " was expected"));
        return number;
    }

    /// 0 to `end` - 1; nothing where `end` is 0.
    std::uint32_t below(const char* member, std::uint32_t value, std::uint32_t end) const;

    /// 0 or 1.
    bool flag(const char* member, std::uint32_t value) const;

    /// The last row of `matrix` has to be 0, 0, 0, 1 but for rounding, and is so exactly in what is returned.
    glm::mat4 affine(const std::string& member, glm::mat4 matrix) const;

    /// x, y, z, w of length 1, but for the error of 8-bit quantised numbers.
    glm::quat unitQuaternion(const char* member, const float (&xyzw)[4]) const;

    /// An index of one of the `count` elements of a kind that were added so far; -1 is none.
    std::optional<std::uint32_t> reference(const char* member, std::int32_t index, std::size_t count) const;

  private:
    static bool allAreFinite(const float* numbers, std::size_t count);
    void requireFinite(const char* member, const float* numbers, std::size_t count,
                       std::size_t components) const;

    // The label is built on demand: there may be millions of elements, of which an error names one.
    const char* kind_;
    std::optional<std::size_t> index_;
    std::string name_;
};

}  // namespace candela
