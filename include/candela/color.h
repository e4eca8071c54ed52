#pragma once

#include <candela/export.h>
#include <candela/image_file.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela {

class DisplayTransform;

/// The display, view and look that a picture is shown through. Empty names stand for the config's defaults
/// (no look).
struct DisplayOptions {
    std::string display = {}, view = {}, look = {};
    /// Stops, -100 to 100: radiance is multiplied by 2^exposure before the display transform.
    double exposure = 0.0;
};

/// An OpenColorIO config: the working space, and the displays and views a picture can be shown through. A
/// cheap handle; copies share.
class CANDELA_API ColorConfig {
  public:
    // Moving copies: no object is left without a config.
    ColorConfig(const ColorConfig&) = default;
    ColorConfig& operator=(const ColorConfig&) = default;
    ~ColorConfig() = default;

    /// candela's own config: linear Rec.709 (the working space), ACEScg; sRGB, Rec.1886 and P3 displays;
    /// un-tone-mapped, ACES 1.x SDR and raw views.
    static ColorConfig builtIn();
    /// Reads a config file. Throws `Error` (badInput) with OpenColorIO's reason; also when the config has no
    /// display, no space of the role `scene_linear`, or one that is not linear.
    static ColorConfig load(const std::string& path);
    /// The command line's rule: `path` if given, else the file `$OCIO` names, else the built-in config.
    static ColorConfig choose(const std::optional<std::string>& path);

    /// The path it was read from, or "built-in".
    const std::string& source() const;
    std::vector<std::string> displays() const;
    /// The views of a display. Throws `Error` (badInput) that lists the existing displays when there is
    /// none of that name.
    std::vector<std::string> views(const std::string& display) const;
    std::vector<std::string> looks() const;
    std::string defaultDisplay() const;
    /// The default view of a display for the working space. Throws as `views`.
    std::string defaultView(const std::string& display) const;

    /// Name of the space that shading works in: the one with the role `scene_linear`.
    std::string workingSpace() const;
    /// Converts linear Rec.709 colours, as files give them, into the working space.
    glm::dmat3 workingFromRec709() const;
    /// The luminance of a colour of the working space, relative to white's, is its dot product with these.
    glm::vec3 luminanceWeights() const;
    /// The working space's primaries and white.
    Chromaticities chromaticities() const;
    /// Assumptions, one line each: a config may not state the primaries of its working space.
    std::vector<std::string> notes() const;

    /// The transform from the working space to a display. Throws `Error` (badInput) that lists the existing
    /// names when one of `options` is unknown, and when the exposure is not -100 to 100.
    DisplayTransform displayTransform(const DisplayOptions& options) const;

  private:
    struct State;
    explicit ColorConfig(std::shared_ptr<const State> state);
    std::shared_ptr<const State> state_;
};

/// From the working space, through exposure, look and view, to the code values of a display. A cheap handle;
/// copies share.
class CANDELA_API DisplayTransform {
  public:
    // Moving copies: no object is left without a transform.
    DisplayTransform(const DisplayTransform&) = default;
    DisplayTransform& operator=(const DisplayTransform&) = default;
    ~DisplayTransform() = default;

    /// The options with the defaults filled in.
    const DisplayOptions& options() const;
    /// How the display encodes, for the tags of a picture file.
    DisplayEncoding encoding() const;
    /// Applies the transform in place on the CPU, by OpenColorIO's own CPU processor: RGBA, 4 floats per
    /// pixel; alpha is not changed. Throws `Error` (badInput) when the size is not a multiple of 4.
    void apply(std::span<float> rgba) const;

    struct State;  ///< Private to the library.
    const State& state() const { return *state_; }
    explicit DisplayTransform(std::shared_ptr<const State> state);

  private:
    std::shared_ptr<const State> state_;
};

}  // namespace candela
