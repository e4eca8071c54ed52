#include "frame.h"

#include "module.h"

#include <nanobind/stl/string.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace candela::python {

namespace {

enum class Kind { radiance, rgba, rgb };

/// An array on its way from the device, which is taken once and stays then. Members are used within a
/// `Session` of the context, `array` with the GIL.
struct PendingData {
    PendingData(const FrameData& frame, Kind wanted)
        : context(frame.renderer->context),
          kind(wanted),
          width(static_cast<std::size_t>(frame.settings.frame.width)),
          height(static_cast<std::size_t>(frame.settings.frame.height)),
          radiance(context),
          picture(context) {}
    ~PendingData() {
        radiance.discard();
        picture.discard();
        tidy(context);
    }

    bool isReady() const {
        return isTaken || (kind == Kind::radiance ? radiance->ready() : picture->ready());
    }
    void take();
    nb::object makeArray();

    ContextPtr context;
    Kind kind;
    std::size_t width, height;
    ContextObject<PendingRadiance> radiance;
    ContextObject<PendingPicture> picture;
    bool isTaken = false;
    std::vector<float> floats;
    std::vector<std::uint8_t> bytes;
    nb::object array;
};

void PendingData::take() {
    if (isTaken) return;
    if (kind == Kind::radiance)
        floats = radiance->get().rgba;
    else
        bytes = picture->get();
    if (kind == Kind::rgb) removeAlpha(bytes);
    isTaken = true;
}

nb::object PendingData::makeArray() {
    if (kind == Kind::radiance) return arrayOf(std::move(floats), {height, width, 4});
    return arrayOf(std::move(bytes), {height, width, kind == Kind::rgb ? std::size_t{3} : std::size_t{4}});
}

/// `PendingArray` in Python.
struct PendingHandle {
    std::shared_ptr<PendingData> data;
};

constexpr const char* user = "PendingArray";

bool isDone(const PendingHandle& self) {
    if (self.data->array.is_valid()) return true;
    const Session session(self.data->context, user, std::try_to_lock);
    return session && self.data->isReady();
}

nb::object result(const PendingHandle& self) {
    PendingData& data = *self.data;
    if (data.array.is_valid()) return data.array;
    {
        const Session session(data.context, user);
        data.take();
    }
    // Another thread may have made it meanwhile.
    if (!data.array.is_valid()) data.array = data.makeArray();
    return data.array;
}

PendingHandle readRadiance(const FrameHandle& self) {
    const auto pending = std::make_shared<PendingData>(*self.data, Kind::radiance);
    reading(self, [&](FrameData& frame) {
        pending->radiance.emplace(frame.accumulates ? frame.renderer->accumulator->readRadiance()
                                                    : frame.frame->readRadiance());
    });
    return {pending};
}

PendingHandle readPicture(const FrameHandle& self, Kind kind, const nb::kwargs& shown) {
    const DisplayTransform transform = transformOf(self, shown);
    const auto pending = std::make_shared<PendingData>(*self.data, kind);
    reading(self, [&](FrameData& frame) {
        pending->picture.emplace(frame.accumulates
                                     ? frame.renderer->accumulator->readDisplayPicture(transform)
                                     : frame.frame->readDisplayPicture(transform));
    });
    return {pending};
}

nb::sig signature(const char* name) {
    return nb::sig(kept(std::string("def ") + name + "(self, *, " + shownKeywords + ") -> PendingArray"));
}

}  // namespace

void bindPendingArrays(nb::module_& module) {
    nb::class_<PendingHandle>(
        module, "PendingArray",
        "An array of a Frame on its way from the device, as a future: its Renderer may draw the next Frame "
        "meanwhile. Any thread may ask.")
        .def("done", &isDone,
             "Whether `result` would return at once. Never waits: while another thread draws with the same "
             "context it is False.")
        .def("result", &result, nb::sig("def result(self) -> numpy.typing.NDArray[typing.Any]"),
             "Waits, without the GIL, and returns the array: equal to that of the Frame's function without "
             "'_async'. Every call returns the same one.")
        .def("__repr__", [](const PendingHandle& self) {
            const PendingData& data = *self.data;
            return "<PendingArray " + std::to_string(data.width) + "x" + std::to_string(data.height) +
                   (data.array.is_valid() ? ", taken>" : ">");
        });
}

void bindPendingReads(nb::class_<FrameHandle>& cls) {
    cls.def("radiance_async", &readRadiance,
            "Begins to read what `radiance` returns, (height, width, 4) of float32, and does not wait.")
        .def(
            "rgba_async",
            [](const FrameHandle& self, const nb::kwargs& shown) {
                return readPicture(self, Kind::rgba, shown);
            },
            nb::arg("shown"), signature("rgba_async"),
            "Begins to read what `rgba` returns, (height, width, 4) of uint8, and does not wait, but for "
            "exposure='auto', which is measured first.")
        .def(
            "rgb_async",
            [](const FrameHandle& self, const nb::kwargs& shown) {
                return readPicture(self, Kind::rgb, shown);
            },
            nb::arg("shown"), signature("rgb_async"),
            "The same of what `rgb` returns, (height, width, 3) of uint8.");
}

}  // namespace candela::python
