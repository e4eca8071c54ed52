#pragma once

#include "fields.h"

#include <candela/import.h>
#include <candela/scene.h>

#include <memory>
#include <string>
#include <vector>

namespace candela::python {

/// A scene and its elements. Elements are handles: an own value until they are appended to a scene, and from
/// then on the element of that index. All members are used with the GIL held; while a thread reads the scene
/// without it, nobody may change it.
struct SceneData {
    Scene scene;
    std::vector<ImportNote> notes;
    std::string plugin, source;
    SceneInfo info;
    int readers = 0;            ///< Threads that read it without the GIL.
    std::uint64_t version = 1;  ///< Grows with every change.

    /// Marks a change. Throws `Error` (badInput) while another thread reads.
    Scene& edit();
};

using ScenePtr = std::shared_ptr<SceneData>;

/// Keeps a scene from being changed while it is read without the GIL.
class SceneReader {
  public:
    explicit SceneReader(SceneData& data) : data_(data) { ++data_.readers; }
    SceneReader(const SceneReader&) = delete;
    SceneReader& operator=(const SceneReader&) = delete;
    ~SceneReader() { --data_.readers; }

  private:
    SceneData& data_;
};

/// The vector of a scene's elements of a type.
inline std::vector<Image>& listOf(Scene& scene, const Image*) {
    return scene.images;
}
inline std::vector<Material>& listOf(Scene& scene, const Material*) {
    return scene.materials;
}
inline std::vector<Mesh>& listOf(Scene& scene, const Mesh*) {
    return scene.meshes;
}
inline std::vector<Cage>& listOf(Scene& scene, const Cage*) {
    return scene.cages;
}
inline std::vector<Skin>& listOf(Scene& scene, const Skin*) {
    return scene.skins;
}
inline std::vector<Node>& listOf(Scene& scene, const Node*) {
    return scene.nodes;
}
inline std::vector<Camera>& listOf(Scene& scene, const Camera*) {
    return scene.cameras;
}
inline std::vector<Light>& listOf(Scene& scene, const Light*) {
    return scene.lights;
}
inline std::vector<Animation>& listOf(Scene& scene, const Animation*) {
    return scene.animations;
}

template <typename T>
struct Element {
    ScenePtr scene;         ///< None: `own` holds the value.
    std::size_t index = 0;  ///< In its scene.
    std::shared_ptr<T> own;

    const T& read() const { return own ? *own : at(scene->scene); }
    T& edit() const { return own ? *own : at(scene->edit()); }

  private:
    T& at(Scene& whole) const {
        std::vector<T>& list = listOf(whole, static_cast<const T*>(nullptr));
        if (index >= list.size())
            throw Error(ErrorKind::badInput, "",
                        std::string(recordOf<T>().name()) + " " + std::to_string(index) +
                            " is no longer in its scene");
        return list[index];
    }
};

/// The element that an argument is.
template <typename T>
Element<T>& elementFrom(nb::handle value, const std::string& where) {
    if (!nb::isinstance<Element<T>>(value))
        failConversion(where, std::string("a ") + recordOf<T>().name(), value);
    return nb::cast<Element<T>&>(value);
}

/// Elements of a scene by index, and by name.
template <typename T>
class ElementList {
  public:
    explicit ElementList(ScenePtr scene) : scene_(std::move(scene)) {}

    std::size_t size() const { return list().size(); }
    Element<T> at(std::size_t index) const { return {scene_, index, nullptr}; }
    Element<T> get(nb::handle key) const;
    /// The value moves into the scene, and the handle refers to the new element; one that belongs to a scene
    /// already is copied.
    std::size_t append(Element<T>& element) {
        T value = element.own && element.own.use_count() == 1 ? std::move(*element.own) : element.read();
        std::vector<T>& target = listOf(scene_->edit(), static_cast<const T*>(nullptr));
        target.push_back(std::move(value));
        if (element.own) element = {scene_, target.size() - 1, nullptr};
        return target.size() - 1;
    }
    void set(std::size_t index, const Element<T>& element) {
        T value = element.read();
        at(index).edit() = std::move(value);
    }
    void clear() { listOf(scene_->edit(), static_cast<const T*>(nullptr)).clear(); }

  private:
    const std::vector<T>& list() const { return listOf(scene_->scene, static_cast<const T*>(nullptr)); }
    ScenePtr scene_;
};

template <typename T>
Element<T> ElementList<T>::get(nb::handle key) const {
    const std::string name = recordOf<T>().name();
    if (nb::isinstance<nb::str>(key)) {
        const std::string text = nb::str(key).c_str();
        const auto found = std::ranges::find(list(), text, &T::name);
        if (found != list().end()) return at(static_cast<std::size_t>(found - list().begin()));
        throw nb::key_error(("the scene has no " + name + " '" + text + "'").c_str());
    }
    const auto count = static_cast<std::int64_t>(size());
    const std::int64_t index = integerFrom(key, INT64_MIN, INT64_MAX, "an index of a " + name);
    if (index >= count || index < -count)
        throw nb::index_error((name + " " + std::to_string(index) + " of " + std::to_string(count)).c_str());
    return at(static_cast<std::size_t>(index < 0 ? index + count : index));
}

/// Binds `Element<T>` under the struct's name and `ElementList<T>`.
template <typename T>
nb::class_<Element<T>> bindElement(nb::module_& module, const char* doc) {
    const Record<T>& record = recordOf<T>();
    nb::class_<Element<T>> cls(module, record.name(), doc);
    cls.def(
        "__init__",
        [](Element<T>* self, const nb::kwargs& values) {
            auto own = std::make_shared<T>();
            recordOf<T>().setAll(*own, values);
            new (self) Element<T>{nullptr, 0, std::move(own)};
        },
        nb::sig(kept("def __init__(self, *" + record.keywords() + ") -> None")));
    defineFields<T>(
        cls, [](const Element<T>& element) -> const T& { return element.read(); },
        [](Element<T>& element) -> T& { return element.edit(); });
    cls.def_prop_ro(
        "index",
        [name = record.name()](const Element<T>& self) {
            if (!self.own) return self.index;
            throw Error(ErrorKind::badInput, "", std::string("the ") + name + " belongs to no scene yet");
        },
        "Its number in the scene, by which others refer to it. InputError before it is appended.");
    cls.def(
        "copy",
        [](const Element<T>& self) {
            return Element<T>{nullptr, 0, std::make_shared<T>(self.read())};
        },
        "An equal one that belongs to no scene.");
    cls.def(
        "__repr__",
        [](const Element<T>& self) { return Convert<std::string>::to(recordOf<T>().text(self.read())); },
        nb::sig("def __repr__(self) -> str"));

    using List = ElementList<T>;
    const std::string element = record.name();
    nb::class_<List> list(module, kept(element + "List"),
                          kept("The elements of a scene, by index or by name."));
    list.def("__len__", &List::size);
    list.def("__getitem__", &List::get,
             nb::sig(kept("def __getitem__(self, key: int | str, /) -> " + element)));
    list.def(
        "__setitem__",
        [](List& self, nb::handle key, const Element<T>& value) { self.set(self.get(key).index, value); },
        nb::sig(kept("def __setitem__(self, key: int | str, value: " + element + ", /) -> None")));
    list.def(
        "__iter__",
        [](const List& self) {
            nb::list all;
            for (std::size_t i = 0; i < self.size(); ++i) all.append(nb::cast(self.at(i)));
            return nb::iter(all);
        },
        nb::sig(kept("def __iter__(self) -> typing.Iterator[" + element + "]")));
    list.def("append", &List::append, nb::arg("element"),
             "Moves the element into the scene; from then on it refers to the scene's. One that belongs to a "
             "scene is copied. Returns its index, by which others refer to it.");
    list.def(
        "extend",
        [](List& self, nb::iterable elements) {
            for (const nb::handle each : elements) self.append(elementFrom<T>(each, "extend"));
        },
        nb::arg("elements"),
        nb::sig(kept("def extend(self, elements: typing.Iterable[" + element + "]) -> None")),
        "Appends each.");
    list.def("clear", &List::clear,
             "Removes all; others must no longer refer to them when the scene is drawn.");
    list.def(
        "__repr__",
        [element](const List& self) {
            return Convert<std::string>::to("<" + element + "List of " + std::to_string(self.size()) + ">");
        },
        nb::sig("def __repr__(self) -> str"));
    return cls;
}

}  // namespace candela::python
