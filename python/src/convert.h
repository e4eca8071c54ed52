#pragma once

#include <candela/error.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <nanobind/nanobind.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// Values between Python and C++. Vectors, matrices and arrays are NumPy arrays. What Python gives is
/// checked, and a fault is a `candela::Error` that names the argument and what was expected.
namespace candela::python {

namespace nb = nanobind;

/// Throws `Error` (badInput): "Mesh.positions: expected ..., not VALUE".
[[noreturn]] void failConversion(const std::string& where, const std::string& expected, nb::handle value);

/// Raises a CandelaWarning, or what the filters of warnings make of it.
void warnUser(const std::string& text);

/// How an argument was given, such as "an array of shape (4, 2)" or "str".
std::string describe(nb::handle value);

/// Numbers of one type, `columns` a row (0: one dimension), from anything that NumPy takes. The shape is (N,
/// columns) or (N,). Integers are checked to be in range.
std::vector<float> floatsFrom(nb::handle value, std::size_t columns, const std::string& where);
std::vector<std::uint32_t> indicesFrom(nb::handle value, std::size_t columns, const std::string& where);

/// An array that owns `values`, without a copy; writable.
nb::object arrayOf(std::vector<float> values, std::vector<std::size_t> shape);
nb::object arrayOf(std::vector<std::uint8_t> values, std::vector<std::size_t> shape);
nb::object arrayOf(std::vector<std::uint32_t> values, std::vector<std::size_t> shape);

/// A read-only copy of numbers that belong to an object: a write to it would not reach the object.
nb::object frozenArray(std::span<const float> values, std::vector<std::size_t> shape);
nb::object frozenArray(std::span<const double> values, std::vector<std::size_t> shape);
nb::object frozenArray(std::span<const std::uint32_t> values, std::vector<std::size_t> shape);

/// `count` numbers from a sequence or an array.
void numbersFrom(nb::handle value, std::span<double> numbers, const std::string& where);

/// The words of an enumeration, as on the command line. A specialisation has `words`.
template <typename E>
struct Words;

/// From and to Python; `type` is the type in the stubs.
template <typename V, typename = void>
struct Convert;

template <>
struct Convert<bool> {
    static std::string type() { return "bool"; }
    static bool from(nb::handle value, const std::string& where);
    static nb::object to(bool value) { return nb::bool_(value); }
};

template <typename V>
struct Convert<V, std::enable_if_t<std::is_floating_point_v<V>>> {
    static std::string type() { return "float"; }
    static V from(nb::handle value, const std::string& where) {
        const double number = PyFloat_AsDouble(value.ptr());
        if (number == -1.0 && PyErr_Occurred()) {
            PyErr_Clear();
            failConversion(where, "a number", value);
        }
        return static_cast<V>(number);
    }
    static nb::object to(V value);
};

/// An integer in the range of `int64_t`, or an error.
std::int64_t integerFrom(nb::handle value, std::int64_t low, std::int64_t high, const std::string& where);

template <typename V>
struct Convert<V, std::enable_if_t<std::is_integral_v<V> && !std::is_same_v<V, bool>>> {
    static std::string type() { return "int"; }
    static V from(nb::handle value, const std::string& where) {
        constexpr auto high =
            sizeof(V) == 8 ? INT64_MAX : static_cast<std::int64_t>(std::numeric_limits<V>::max());
        return static_cast<V>(
            integerFrom(value, static_cast<std::int64_t>(std::numeric_limits<V>::min()), high, where));
    }
    static nb::object to(V value) { return nb::int_(value); }
};

template <>
struct Convert<std::string> {
    static std::string type() { return "str"; }
    static std::string from(nb::handle value, const std::string& where);
    static nb::object to(const std::string& value);
};

template <typename V>
struct Convert<V, std::enable_if_t<std::is_enum_v<V>>> {
    static std::string type() {
        std::string text = "typing.Literal[";
        for (const auto& [word, ignored] : Words<V>::words)
            text += (text.back() == '[' ? "'" : ", '") + std::string(word) + "'";
        return text + "]";
    }
    static V from(nb::handle value, const std::string& where) {
        std::string all;
        for (const auto& [word, element] : Words<V>::words) {
            if (nb::isinstance<nb::str>(value) && nb::str(value).c_str() == std::string(word)) return element;
            all += (all.empty() ? "'" : ", '") + std::string(word) + "'";
        }
        failConversion(where, "one of " + all, value);
    }
    static nb::object to(V value) {
        for (const auto& [word, element] : Words<V>::words)
            if (element == value) return nb::str(word);
        return nb::none();
    }
};

template <typename V>
struct Convert<std::optional<V>> {
    static std::string type() { return Convert<V>::type() + " | None"; }
    static std::optional<V> from(nb::handle value, const std::string& where) {
        if (value.is_none()) return std::nullopt;
        return Convert<V>::from(value, where);
    }
    static nb::object to(const std::optional<V>& value) {
        return value ? Convert<V>::to(*value) : nb::none();
    }
};

constexpr const char* floatArray = "numpy.typing.NDArray[numpy.float32]";
constexpr const char* doubleArray = "numpy.typing.NDArray[numpy.float64]";
constexpr const char* indexArray = "numpy.typing.NDArray[numpy.uint32]";
constexpr const char* anyArray = "numpy.typing.ArrayLike";

template <int N, typename T>
struct Convert<glm::vec<N, T>> {
    static std::string type() { return sizeof(T) == 4 ? floatArray : doubleArray; }
    static glm::vec<N, T> from(nb::handle value, const std::string& where) {
        std::array<double, N> numbers;
        numbersFrom(value, numbers, where);
        glm::vec<N, T> result;
        for (int i = 0; i < N; ++i) result[i] = static_cast<T>(numbers[static_cast<std::size_t>(i)]);
        return result;
    }
    static nb::object to(const glm::vec<N, T>& value) {
        return frozenArray(std::span<const T>(&value[0], N), {static_cast<std::size_t>(N)});
    }
};

/// x, y, z, w, as in glTF and SciPy.
template <>
struct Convert<glm::quat> {
    static std::string type() { return floatArray; }
    static glm::quat from(nb::handle value, const std::string& where);
    static nb::object to(const glm::quat& value);
};

/// Rows of the matrix are rows of the array: points are columns, and `matrix @ point` moves one.
template <>
struct Convert<glm::mat4> {
    static std::string type() { return floatArray; }
    static glm::mat4 from(nb::handle value, const std::string& where);
    static nb::object to(const glm::mat4& value);
};

template <>
struct Convert<std::vector<float>> {
    static std::string type() { return floatArray; }
    static std::vector<float> from(nb::handle value, const std::string& where) {
        return floatsFrom(value, 0, where);
    }
    static nb::object to(const std::vector<float>& value) { return frozenArray(value, {value.size()}); }
};

template <>
struct Convert<std::vector<std::uint32_t>> {
    static std::string type() { return indexArray; }
    static std::vector<std::uint32_t> from(nb::handle value, const std::string& where) {
        return indicesFrom(value, 0, where);
    }
    static nb::object to(const std::vector<std::uint32_t>& value) {
        return frozenArray(value, {value.size()});
    }
};

template <int N>
std::vector<glm::vec<N, float>> vectorsFrom(nb::handle value, const std::string& where) {
    const std::vector<float> numbers = floatsFrom(value, N, where);
    std::vector<glm::vec<N, float>> vectors(numbers.size() / N);
    if (!numbers.empty()) std::memcpy(&vectors[0], numbers.data(), numbers.size() * sizeof(float));
    return vectors;
}

template <int N>
struct Convert<std::vector<glm::vec<N, float>>> {
    static std::string type() { return floatArray; }
    static std::vector<glm::vec<N, float>> from(nb::handle value, const std::string& where) {
        return vectorsFrom<N>(value, where);
    }
    static nb::object to(const std::vector<glm::vec<N, float>>& value) {
        const float* first = value.empty() ? nullptr : &value[0][0];
        return frozenArray(std::span(first, value.size() * N), {value.size(), static_cast<std::size_t>(N)});
    }
};

template <>
struct Convert<std::vector<glm::mat4>> {
    static std::string type() { return floatArray; }
    static std::vector<glm::mat4> from(nb::handle value, const std::string& where);
    static nb::object to(const std::vector<glm::mat4>& value);
};

/// Structs that are bound as classes, copied.
template <typename V>
struct ConvertClass {
    static std::string type();  // Defined beside the class.
    static V from(nb::handle value, const std::string& where) {
        if (!nb::isinstance<V>(value)) failConversion(where, "a " + ConvertClass<V>::type(), value);
        return nb::cast<V>(value);
    }
    static nb::object to(const V& value) { return nb::cast(value); }
};

template <typename V>
constexpr bool isVector = false;
template <int N>
constexpr bool isVector<glm::vec<N, float>> = true;

/// A list of such, as a tuple: appending to it would not reach the object.
template <typename V>
struct Convert<std::vector<V>, std::enable_if_t<!isVector<V> && !std::is_arithmetic_v<V>>> {
    static std::string type() { return "tuple[" + Convert<V>::type() + ", ...]"; }
    static std::vector<V> from(nb::handle value, const std::string& where) {
        std::vector<V> list;
        if (!nb::hasattr(value, "__iter__") || nb::isinstance<nb::str>(value))
            failConversion(where, "a sequence", value);
        for (const nb::handle element : value)
            list.push_back(Convert<V>::from(element, where + "[" + std::to_string(list.size()) + "]"));
        return list;
    }
    static nb::object to(const std::vector<V>& value) {
        nb::list list;
        for (const V& element : value) list.append(Convert<V>::to(element));
        return nb::tuple(list);
    }
};

}  // namespace candela::python
