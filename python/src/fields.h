#pragma once

#include "convert.h"

#include <nanobind/nanobind.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace candela::python {

/// Keeps the texts that nanobind refers to.
inline const char* kept(std::string text) {
    static std::deque<std::string> texts;
    return texts.emplace_back(std::move(text)).c_str();
}

/// A member of a C++ struct as an attribute in Python.
template <typename T>
struct Field {
    const char* name;
    std::string type;  ///< In the stubs.
    const char* doc;   ///< Meaning, unit and range; the default is added.
    std::function<void(T&, nb::handle, const std::string&)> set;
    std::function<nb::object(const T&)> get;
};

/// The attributes of a struct, from which its class in Python is made: the constructor with keywords, the
/// attributes and the text of `repr`.
template <typename T>
class Record {
  public:
    explicit Record(const char* name) : name_(name) {}

    /// `access(T&)` gives the member.
    template <typename Access>
    Record& field(const char* name, Access access, const char* doc) {
        using V = std::remove_cvref_t<decltype(access(std::declval<T&>()))>;
        fields_.push_back(
            {name, Convert<V>::type(), doc,
             [access](T& object, nb::handle value, const std::string& where) {
                 access(object) = Convert<V>::from(value, where);
             },
             [access](const T& object) { return Convert<V>::to(access(const_cast<T&>(object))); }});
        return *this;
    }

    template <typename V>
    Record& field(const char* name, V T::*member, const char* doc) {
        return field(
            name, [member](T& object) -> V& { return object.*member; }, doc);
    }

    /// A field with a conversion of its own.
    Record& custom(const char* name, const std::string& type, const char* doc,
                   std::function<void(T&, nb::handle, const std::string&)> set,
                   std::function<nb::object(const T&)> get) {
        fields_.push_back({name, type, doc, std::move(set), std::move(get)});
        return *this;
    }

    const char* name() const { return name_; }
    const std::vector<Field<T>>& fields() const { return fields_; }

    void set(T& object, const std::string& name, nb::handle value) const {
        const auto found =
            std::ranges::find(fields_, name, [](const Field<T>& f) { return std::string(f.name); });
        if (found == fields_.end()) throw nb::type_error(unknownText(name).c_str());
        found->set(object, value, std::string(name_) + "." + name);
    }

    /// Sets attributes by keywords. A name that there is none of is a TypeError, as of other functions.
    void setAll(T& object, const nb::kwargs& values) const {
        for (const auto& [name, value] : values) set(object, nb::str(name).c_str(), value);
    }

    /// "Name(a=1, b=2)": what differs from the default, without large arrays.
    std::string text(const T& object) const {
        const T plain{};
        std::string result = std::string(name_) + "(";
        for (const Field<T>& field : fields_) {
            const std::string value = valueText(field.get(object));
            if (value == valueText(field.get(plain))) continue;
            result += (result.back() == '(' ? "" : ", ") + std::string(field.name) + "=" + value;
        }
        return result + ")";
    }

    /// The keywords with their types, for the signatures in the stubs.
    std::string keywords() const { return keywordsWithout({}); }

    /// The same without some.
    std::string keywordsWithout(const std::vector<std::string>& left) const {
        std::string result;
        for (const Field<T>& field : fields_)
            if (std::ranges::find(left, field.name) == left.end())
                result += ", " + std::string(field.name) + ": " + inputType(field.type) + " = ...";
        return result;
    }

    std::string docOf(const Field<T>& field) const {
        const std::string value = valueText(field.get(T{}));
        return std::string(field.doc) + " Default: " + (value.empty() ? "''" : value) + ".";
    }

    /// What may be assigned: arrays from everything that NumPy takes.
    static std::string inputType(std::string type) {
        for (const char* array : {floatArray, doubleArray, indexArray})
            for (std::size_t at = type.find(array); at != std::string::npos; at = type.find(array))
                type.replace(at, std::string(array).size(), anyArray);
        return type.starts_with("tuple[") && type.ends_with(", ...]")
                   ? "typing.Iterable[" + type.substr(6, type.rfind(',') - 6) + "]"
                   : type;
    }

  private:
    std::string unknownText(const std::string& name) const {
        std::string text = std::string(name_) + " has no attribute '" + name + "'; it has";
        for (const Field<T>& field : fields_)
            text += (&field == &fields_.front() ? " " : ", ") + std::string(field.name);
        return text;
    }

    static std::string valueText(const nb::object& value) {
        if (nb::hasattr(value, "tolist")) {
            const auto size = nb::cast<std::size_t>(value.attr("size"));
            if (size > 16) return "<" + describe(value) + ">";
            return numbersText(value.attr("tolist")());
        }
        if (nb::isinstance<nb::tuple>(value) && nb::len(value) > 4)
            return "<" + std::to_string(nb::len(value)) + " elements>";
        return nb::repr(value).c_str();
    }

    // A list of floats as their shortest texts.
    static std::string numbersText(const nb::object& value) {
        if (!nb::isinstance<nb::list>(value)) {
            const bool isFloat = nb::isinstance<nb::float_>(value);
            return nb::repr(isFloat ? Convert<float>::to(nb::cast<float>(value)) : value).c_str();
        }
        std::string text = "[";
        for (const nb::handle element : value)
            text += (text.size() > 1 ? ", " : "") + numbersText(nb::borrow(element));
        return text + "]";
    }

    const char* name_;
    std::vector<Field<T>> fields_;
};

/// The record of a struct, which `describeFields` of its file fills once.
template <typename T>
const Record<T>& recordOf();

template <typename T>
std::string ConvertClass<T>::type() {
    return recordOf<T>().name();
}

/// A property for each field; `read(holder)` gives the struct and `edit(holder)` lets it change.
template <typename T, typename Class, typename Read, typename Edit>
void defineFields(Class& cls, Read read, Edit edit) {
    using Holder = typename Class::Type;
    const Record<T>& record = recordOf<T>();
    for (const Field<T>& field : record.fields()) {
        const std::string name = field.name;
        const char* getter = kept("def " + name + "(self) -> " + field.type);
        const char* setter =
            kept("def " + name + "(self, value: " + Record<T>::inputType(field.type) + ", /) -> None");
        const char* doc = kept(record.docOf(field));
        const std::string where = std::string(record.name()) + "." + name;
        cls.def_prop_rw(
            field.name, [&field, read](const Holder& holder) { return field.get(read(holder)); },
            [&field, edit, where](Holder& holder, nb::object value) {
                field.set(edit(holder), value, where);
            },
            nb::for_getter(nb::sig(getter)), nb::for_setter(nb::sig(setter)), nb::arg("value").none(), doc);
    }
}

/// Binds a struct as a value that does not change: attributes are read-only, `replace` gives a changed copy.
/// A copy in a list or another object would not see changes.
template <typename T>
nb::class_<T> bindValue(nb::module_& module, const char* doc) {
    const Record<T>& record = recordOf<T>();
    nb::class_<T> cls(module, record.name(), doc);
    cls.def(
        "__init__",
        [](T* self, const nb::kwargs& values) {
            T object{};
            recordOf<T>().setAll(object, values);
            new (self) T(std::move(object));
        },
        nb::sig(kept("def __init__(self, *" + record.keywords() + ") -> None")));
    for (const Field<T>& field : record.fields()) {
        const char* getter = kept("def " + std::string(field.name) + "(self) -> " + field.type);
        cls.def_prop_ro(
            field.name, [&field](const T& self) { return field.get(self); }, nb::sig(getter),
            kept(record.docOf(field)));
    }
    cls.def(
        "replace",
        [](const T& self, const nb::kwargs& values) {
            T changed = self;
            recordOf<T>().setAll(changed, values);
            return changed;
        },
        nb::sig(kept("def replace(self, *" + record.keywords() + ") -> " + record.name())),
        "A copy in which these attributes have other values.");
    cls.def(
        "__repr__", [](const T& self) { return Convert<std::string>::to(recordOf<T>().text(self)); },
        nb::sig("def __repr__(self) -> str"));
    cls.def(
        "__eq__",
        [](const T& self, nb::handle other) {
            return nb::isinstance<T>(other) &&
                   recordOf<T>().text(self) == recordOf<T>().text(*nb::inst_ptr<T>(other));
        },
        nb::sig("def __eq__(self, other: object, /) -> bool"));
    return cls;
}

}  // namespace candela::python
