#include "frame.h"

#include <candela/exposure.h>
#include <candela/image_file.h>

#include <algorithm>

namespace candela::python {

const char* const shownKeywords =
    "exposure: float | typing.Literal['auto'] = 0.0, display: str = '', view: str = '', look: str = ''";

HdrImage radianceOf(FrameData& frame) {
    return frame.accumulates ? frame.renderer->accumulator->radiance() : frame.frame->radiance();
}

double autoExposureOf(const FrameHandle& self) {
    if (!self.data->autoExposure) {
        const glm::vec3 weights = self.data->renderer->color.luminanceWeights();
        const auto measured = reading(self, [&](FrameData& frame) {
            const HdrImage image = radianceOf(frame);
            return autoExposure(std::span(&image, 1), weights);
        });
        self.data->autoExposure = measured.value_or(0.0);
    }
    return *self.data->autoExposure;
}

namespace {

struct Shown {
    nb::object exposure = nb::float_(0.0);
    DisplayOptions options;
};

Shown shownBy(const nb::kwargs& keywords) {
    Shown shown;
    for (const auto& [key, value] : keywords) {
        const std::string name = nb::str(key).c_str();
        if (name == "exposure")
            shown.exposure = nb::borrow(value);
        else if (name == "display")
            shown.options.display = Convert<std::string>::from(value, name);
        else if (name == "view")
            shown.options.view = Convert<std::string>::from(value, name);
        else if (name == "look")
            shown.options.look = Convert<std::string>::from(value, name);
        else
            throw nb::type_error(
                ("a picture is shown by exposure, display, view and look, not by '" + name + "'").c_str());
    }
    return shown;
}

std::vector<std::uint8_t> displayed(const FrameHandle& self, const DisplayTransform& transform) {
    return reading(self, [&](FrameData& frame) {
        return frame.accumulates ? frame.renderer->accumulator->displayPicture(transform)
                                 : frame.frame->displayPicture(transform);
    });
}

}  // namespace

nb::object imageArray(HdrImage image) {
    return arrayOf(std::move(image.rgba),
                   {static_cast<std::size_t>(image.height), static_cast<std::size_t>(image.width), 4});
}

void removeAlpha(std::vector<std::uint8_t>& pixels) {
    for (std::size_t i = 0; i < pixels.size() / 4; ++i)
        std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(4 * i), 3,
                    pixels.begin() + static_cast<std::ptrdiff_t>(3 * i));
    pixels.resize(pixels.size() / 4 * 3);
}

DisplayTransform transformBy(const ColorConfig& color, const nb::kwargs& keywords,
                             const std::function<double()>& measured) {
    Shown shown = shownBy(keywords);
    const bool isAutomatic = nb::isinstance<nb::str>(shown.exposure);
    if (isAutomatic && !shown.exposure.equal(nb::str("auto")))
        failConversion("exposure", "stops or 'auto'", shown.exposure);
    shown.options.exposure = isAutomatic ? measured() : Convert<double>::from(shown.exposure, "exposure");
    return color.displayTransform(shown.options);
}

DisplayTransform transformOf(const FrameHandle& self, const nb::kwargs& keywords) {
    return transformBy(self.data->renderer->color, keywords, [&] { return autoExposureOf(self); });
}

nb::object rgba(const FrameHandle& self, const nb::kwargs& keywords) {
    const FrameSettings& settings = self.data->settings.frame;
    return arrayOf(displayed(self, transformOf(self, keywords)),
                   {static_cast<std::size_t>(settings.height), static_cast<std::size_t>(settings.width), 4});
}

nb::object rgb(const FrameHandle& self, const nb::kwargs& keywords) {
    const FrameSettings& settings = self.data->settings.frame;
    std::vector<std::uint8_t> pixels = displayed(self, transformOf(self, keywords));
    removeAlpha(pixels);
    return arrayOf(std::move(pixels),
                   {static_cast<std::size_t>(settings.height), static_cast<std::size_t>(settings.width), 3});
}

std::vector<std::string> notesOf(const FrameHandle& self, double exposure) {
    constexpr double minLitShare = 0.05;  // Below it the rest of what is in view is taken for unlit.
    std::vector<std::string> notes;
    ExposureCounts counts;
    LayerCounts layers;
    const glm::vec3 weights = self.data->renderer->color.luminanceWeights();
    reading(self, [&](FrameData& frame) {
        counts = countExposure(radianceOf(frame), weights, exposure);
        layers = frame.frame->layerCounts();
    });
    const auto surfaces = static_cast<double>(counts.surfaces);
    if (counts.surfaces == 0)
        notes.emplace_back("nothing of the scene is in view: camera=None shows all of it");
    else if (static_cast<double>(counts.lit) < minLitShare * surfaces)
        notes.emplace_back("next to nothing in view is lit: environment=Environment.studio() lights it");
    else if (static_cast<double>(counts.overBlack) < minLitShare * surfaces)
        notes.emplace_back("what is lit is too dark to be seen: exposure='auto' brightens it");
    else if (2 * counts.overWhite > counts.surfaces)
        notes.emplace_back("more than half of what is in view is over white: exposure='auto' darkens it");
    if (layers.fragmentsBeyond > 0)
        notes.push_back(std::to_string(layers.fragmentsBeyond) +
                        " pixels of transparent surfaces lie beyond the layers that are drawn (layers=)");
    return notes;
}

namespace {

void warnAll(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) warnUser(note);
}

void saveExr(const FrameHandle& self, const std::filesystem::path& path) {
    std::vector<ExrAttribute> attributes{{"samples", std::to_string(self.data->samples)}};
    const HdrImage image = reading(self, [&](FrameData& frame) {
        for (const Aov& aov : *frame.aovs)
            if (frame.accumulates)
                attributes.push_back(
                    {"filter." + aov.name, toString(frame.renderer->accumulator->filterOf(aov.name))});
        return radianceOf(frame);
    });
    const Chromaticities chromaticities = self.data->renderer->color.chromaticities();
    const nb::gil_scoped_release release;
    writeExr(path, image, *self.data->aovs, chromaticities, attributes);
}

void savePng(const FrameHandle& self, const std::filesystem::path& path, const nb::kwargs& keywords) {
    const DisplayTransform transform = transformOf(self, keywords);
    const FrameSettings& settings = self.data->settings.frame;
    if (settings.debugView == DebugView::none) warnAll(notesOf(self, transform.options().exposure));
    std::vector<std::uint8_t> pixels = displayed(self, transform);
    const nb::gil_scoped_release release;
    for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
    writePng(path, static_cast<std::uint32_t>(settings.width), static_cast<std::uint32_t>(settings.height),
             pixels, transform.encoding());
}

}  // namespace

void save(const FrameHandle& self, const std::filesystem::path& path, const nb::kwargs& keywords) {
    const std::string ending = path.extension().string();
    if (ending == ".png") return savePng(self, path, keywords);
    if (ending == ".exr" && keywords.size() == 0) return saveExr(self, path);
    if (ending == ".exr")
        throw Error(ErrorKind::badInput, path.string(),
                    "an .exr holds scene-linear light: exposure, display, view and look do not change it");
    throw Error(ErrorKind::badInput, path.string(), "a picture is saved as .png or .exr");
}

}  // namespace candela::python
