#pragma once

#include "renderer.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace candela::python {

/// Calls `use(FrameData&)` without the GIL while the frame can be read.
template <typename Use>
auto reading(const FrameHandle& self, const Use& use) {
    const Session session(self.data->renderer->context, "Frame");
    self.data->requireLast();
    return use(*self.data);
}

/// Within `reading`: the frame's radiance, or the mean of its samples.
HdrImage radianceOf(FrameData& frame);

/// Radiance as an array of (height, width, 4).
nb::object imageArray(HdrImage image);

/// Makes RGB pixels of RGBA ones.
void removeAlpha(std::vector<std::uint8_t>& pixels);

/// Binds what a host takes of a frame: its textures, and what shows it.
void bindFrameTextures(nb::module_& module, nb::class_<FrameHandle>& cls);
/// Binds what is read without waiting.
void bindPendingArrays(nb::module_& module);
void bindPendingReads(nb::class_<FrameHandle>& cls);

/// How a picture is shown: the keywords of `rgba`, `rgb`, `save` and `display` in signatures.
extern const char* const shownKeywords;

/// The transform of these keywords; `measured` gives the exposure where it is 'auto'.
DisplayTransform transformBy(const ColorConfig& color, const nb::kwargs& keywords,
                             const std::function<double()>& measured);

/// The transform of these keywords for a frame; measures the exposure where it is 'auto'.
DisplayTransform transformOf(const FrameHandle& self, const nb::kwargs& keywords);
/// The exposure that is measured, stops; 0 where nothing is lit.
double autoExposureOf(const FrameHandle& self);

/// The displayed picture: (height, width, 4) and (height, width, 3) of uint8.
nb::object rgba(const FrameHandle& self, const nb::kwargs& keywords);
nb::object rgb(const FrameHandle& self, const nb::kwargs& keywords);

/// What a user should know of the picture, with the remedy. `exposure`: stops.
std::vector<std::string> notesOf(const FrameHandle& self, double exposure);

/// Writes a PNG or an EXR file.
void save(const FrameHandle& self, const std::filesystem::path& path, const nb::kwargs& keywords);

}  // namespace candela::python
