#pragma once

#include "renderer.h"

#include <filesystem>
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

/// How a picture is shown: the keywords of `rgba`, `rgb`, `save` and `display` in signatures.
extern const char* const shownKeywords;

/// The transform of these keywords; measures the exposure where it is 'auto'.
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
