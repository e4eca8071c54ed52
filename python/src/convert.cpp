#include "convert.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <cstring>

namespace candela::python {

namespace {

std::string typeName(nb::handle value) {
    return nb::borrow<nb::str>(value.type().attr("__name__")).c_str();
}

bool hasShape(nb::handle value) {
    return nb::hasattr(value, "shape") && nb::hasattr(value, "dtype");
}

std::string shapeText(std::size_t columns) {
    return columns == 0 ? "(N,)" : "(N, " + std::to_string(columns) + ")";
}

// `value` as a contiguous array of `dtype`. An empty list has every shape.
nb::object numpyArray(nb::handle value, const char* dtype, std::size_t columns, const std::string& where) {
    const std::string expected = "numbers of shape " + shapeText(columns);
    const nb::module_ numpy = nb::module_::import_("numpy");
    nb::object array;
    try {
        array = numpy.attr("ascontiguousarray")(value, nb::arg("dtype") = dtype);
    } catch (const nb::python_error&) {
        failConversion(where, expected, value);
    }
    const nb::tuple shape = nb::borrow<nb::tuple>(array.attr("shape"));
    const std::size_t size = nb::cast<std::size_t>(array.attr("size"));
    const bool fits =
        columns == 0 ? shape.size() == 1 : shape.size() == 2 && nb::cast<std::size_t>(shape[1]) == columns;
    if (!fits && (size != 0 || shape.size() > 2)) failConversion(where, expected, array);
    return array;
}

template <typename T>
std::vector<T> copied(const nb::object& array) {
    const auto view = nb::cast<nb::ndarray<const T, nb::c_contig, nb::device::cpu>>(array);
    return std::vector<T>(view.data(), view.data() + view.size());
}

template <typename T>
nb::object owned(std::vector<T> values, const std::vector<std::size_t>& shape) {
    auto* owner = new std::vector<T>(std::move(values));
    if (owner->empty()) owner->reserve(1);
    const nb::capsule capsule(owner,
                              [](void* pointer) noexcept { delete static_cast<std::vector<T>*>(pointer); });
    return nb::cast(nb::ndarray<nb::numpy, T>(owner->data(), shape.size(), shape.data(), capsule));
}

template <typename T>
nb::object frozen(std::span<const T> values, const std::vector<std::size_t>& shape) {
    auto* owner = new std::vector<T>(values.begin(), values.end());
    if (owner->empty()) owner->reserve(1);
    const nb::capsule capsule(owner,
                              [](void* pointer) noexcept { delete static_cast<std::vector<T>*>(pointer); });
    return nb::cast(nb::ndarray<nb::numpy, const T>(owner->data(), shape.size(), shape.data(), capsule));
}

}  // namespace

void warnUser(const std::string& text) {
    const nb::object category = nb::module_::import_("candela.errors").attr("CandelaWarning");
    if (PyErr_WarnEx(category.ptr(), text.c_str(), 1) != 0) throw nb::python_error();
}

std::string describe(nb::handle value) {
    if (value.is_none()) return "None";
    if (hasShape(value)) {
        const nb::str shape(nb::handle(value.attr("shape"))), dtype(nb::handle(value.attr("dtype")));
        return "an array of shape " + std::string(shape.c_str()) + " of " + dtype.c_str();
    }
    if (nb::isinstance<nb::str>(value)) return "'" + std::string(nb::str(value).c_str()) + "'";
    if (nb::isinstance<nb::int_>(value) || nb::isinstance<nb::float_>(value)) return nb::str(value).c_str();
    return "an object of type " + typeName(value);
}

void failConversion(const std::string& where, const std::string& expected, nb::handle value) {
    throw Error(ErrorKind::badInput, "", where + ": expected " + expected + ", not " + describe(value));
}

std::vector<float> floatsFrom(nb::handle value, std::size_t columns, const std::string& where) {
    return copied<float>(numpyArray(value, "float32", columns, where));
}

std::vector<std::uint32_t> indicesFrom(nb::handle value, std::size_t columns, const std::string& where) {
    const nb::module_ numpy = nb::module_::import_("numpy");
    const nb::object array = numpy.attr("asarray")(value);
    const std::string kind = nb::borrow<nb::str>(array.attr("dtype").attr("kind")).c_str();
    if (nb::cast<std::size_t>(array.attr("size")) == 0) return {};
    if (kind != "u" && kind != "i")
        failConversion(where, "whole numbers of shape " + shapeText(columns), array);
    const std::vector<std::int64_t> numbers =
        copied<std::int64_t>(numpyArray(array, "int64", columns, where));
    std::vector<std::uint32_t> indices(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] < 0 || numbers[i] > UINT32_MAX)
            throw Error(ErrorKind::badInput, "",
                        where + ": number " + std::to_string(i) + " is " + std::to_string(numbers[i]) +
                            ", which is no index");
        indices[i] = static_cast<std::uint32_t>(numbers[i]);
    }
    return indices;
}

nb::object arrayOf(std::vector<float> values, std::vector<std::size_t> shape) {
    return owned(std::move(values), shape);
}
nb::object arrayOf(std::vector<std::uint8_t> values, std::vector<std::size_t> shape) {
    return owned(std::move(values), shape);
}
nb::object arrayOf(std::vector<std::uint32_t> values, std::vector<std::size_t> shape) {
    return owned(std::move(values), shape);
}
nb::object frozenArray(std::span<const float> values, std::vector<std::size_t> shape) {
    return frozen(values, shape);
}
nb::object frozenArray(std::span<const double> values, std::vector<std::size_t> shape) {
    return frozen(values, shape);
}
nb::object frozenArray(std::span<const std::uint32_t> values, std::vector<std::size_t> shape) {
    return frozen(values, shape);
}

void numbersFrom(nb::handle value, std::span<double> numbers, const std::string& where) {
    const std::string expected = std::to_string(numbers.size()) + " numbers";
    if (!PySequence_Check(value.ptr()) || nb::isinstance<nb::str>(value))
        failConversion(where, expected, value);
    const Py_ssize_t size = PySequence_Size(value.ptr());
    if (size != static_cast<Py_ssize_t>(numbers.size())) {
        PyErr_Clear();
        failConversion(where, expected, value);
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const nb::object item = nb::steal(PySequence_GetItem(value.ptr(), static_cast<Py_ssize_t>(i)));
        if (!item.is_valid()) throw nb::python_error();
        numbers[i] = Convert<double>::from(item, where);
    }
}

bool Convert<bool>::from(nb::handle value, const std::string& where) {
    if (value.is(Py_True)) return true;
    if (value.is(Py_False)) return false;
    if (hasShape(value) && typeName(value).starts_with("bool")) return nb::cast<bool>(value.attr("item")());
    failConversion(where, "True or False", value);
}

template <typename V>
nb::object Convert<V, std::enable_if_t<std::is_floating_point_v<V>>>::to(V value) {
    if constexpr (sizeof(V) == 8) return nb::float_(value);
    // The shortest text of a float names it: 0.1f reads as 0.1, not as 0.10000000149.
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.9g", static_cast<double>(value));
    for (int digits = 6; digits < 9; ++digits) {
        std::array<char, 32> shorter{};
        std::snprintf(shorter.data(), shorter.size(), "%.*g", digits, static_cast<double>(value));
        if (std::strtof(shorter.data(), nullptr) != value) continue;
        text = shorter;
        break;
    }
    return nb::float_(std::strtod(text.data(), nullptr));
}
template nb::object Convert<float>::to(float);
template nb::object Convert<double>::to(double);

std::int64_t integerFrom(nb::handle value, std::int64_t low, std::int64_t high, const std::string& where) {
    const bool isInteger = PyIndex_Check(value.ptr()) && !PyBool_Check(value.ptr());
    int overflow = 0;
    const std::int64_t number = isInteger ? PyLong_AsLongLongAndOverflow(value.ptr(), &overflow) : -1;
    if (!isInteger || PyErr_Occurred() || overflow != 0 || number < low || number > high) {
        PyErr_Clear();
        failConversion(where, "a whole number of " + std::to_string(low) + " to " + std::to_string(high),
                       value);
    }
    return number;
}

std::string Convert<std::string>::from(nb::handle value, const std::string& where) {
    if (!nb::isinstance<nb::str>(value)) failConversion(where, "a text", value);
    return nb::str(value).c_str();
}

nb::object Convert<std::string>::to(const std::string& value) {
    return nb::steal(PyUnicode_DecodeUTF8(value.data(), static_cast<Py_ssize_t>(value.size()), "replace"));
}

glm::quat Convert<glm::quat>::from(nb::handle value, const std::string& where) {
    const glm::vec4 q = Convert<glm::vec4>::from(value, where);
    return {q.w, q.x, q.y, q.z};
}

nb::object Convert<glm::quat>::to(const glm::quat& value) {
    return Convert<glm::vec4>::to({value.x, value.y, value.z, value.w});
}

glm::mat4 Convert<glm::mat4>::from(nb::handle value, const std::string& where) {
    const std::vector<float> rows = floatsFrom(value, 4, where);
    if (rows.size() != 16) failConversion(where, "a matrix of shape (4, 4)", value);
    glm::mat4 matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = rows[static_cast<std::size_t>(row * 4 + column)];
    return matrix;
}

nb::object Convert<glm::mat4>::to(const glm::mat4& value) {
    const glm::mat4 rows = glm::transpose(value);
    return frozenArray(std::span(&rows[0][0], 16), {4, 4});
}

std::vector<glm::mat4> Convert<std::vector<glm::mat4>>::from(nb::handle value, const std::string& where) {
    std::vector<glm::mat4> matrices;
    for (const nb::handle matrix : value) matrices.push_back(Convert<glm::mat4>::from(matrix, where));
    return matrices;
}

nb::object Convert<std::vector<glm::mat4>>::to(const std::vector<glm::mat4>& value) {
    std::vector<glm::mat4> rows(value.size());
    std::ranges::transform(value, rows.begin(), [](const glm::mat4& m) { return glm::transpose(m); });
    const float* first = rows.empty() ? nullptr : &rows[0][0][0];
    return frozenArray(std::span(first, rows.size() * 16), {rows.size(), 4, 4});
}

}  // namespace candela::python
