#include "run_notes.h"

#include "common/scene_lights.h"

#include <algorithm>
#include <optional>
#include <sstream>

void PictureNotes::add(const candela::ExposureCounts& counts) {
    ++pictures_;
    if (const std::optional<std::string> note = pictureNote(counts)) ++counts_[*note];
}

void PictureNotes::tell(RunReport& report) const {
    for (const auto& [note, count] : counts_) {
        const std::string share =
            "in " + std::to_string(count) + " of " + std::to_string(pictures_) + " pictures ";
        report.note((pictures_ == 1 ? "" : share) + note);
    }
}

void LayerNotes::add(const candela::LayerCounts& counts) {
    ++pictures_;
    incomplete_ += counts.fragmentsBeyond > 0;
    maxFragmentsBeyond_ = std::max(maxFragmentsBeyond_, counts.fragmentsBeyond);
}

void LayerNotes::tell(RunReport& report, std::uint32_t layers) const {
    if (incomplete_ == 0) return;
    const std::string share = pictures_ == 1 ? ""
                                             : "in " + std::to_string(incomplete_) + " of " +
                                                   std::to_string(pictures_) + " pictures up to ";
    report.note(share + std::to_string(maxFragmentsBeyond_) +
                " pixels of transparent surfaces are left out: they lie beyond the " +
                std::to_string(layers) + " layers that are drawn (--layers)");
}

void noteLights(RunReport& report, const candela::LightReport& lights, float rangeLoss) {
    if (lights.rangesAssigned == 0) return;
    std::ostringstream text;
    const bool one = lights.rangesAssigned == 1;
    text << lights.rangesAssigned << (one ? " light" : " lights") << " without a range: drawn up to "
         << lights.minRange;
    if (lights.minRange < lights.maxRange) text << " to " << lights.maxRange;
    text << " m, which takes at most " << 100.0f * rangeLoss
         << " % of their light from any point (--range-loss)";
    report.note(text.str());
}

void noteMissingSubdivider(RunReport& report, const candela::CageReport& cages) {
    if (cages.cages == 0 || cages.subdivided) return;
    report.note(
        "no plugin that refines subdivision cages was found (opensubdiv does): their polygons are drawn");
}

void noteLodClamped(RunReport& report, const candela::CageReport& cages) {
    if (cages.lodClamped == 0) return;
    report.note(std::to_string(cages.lodClamped) +
                " cages are coarser than --subdivision-edge asks for: --subdivision-max-level or the "
                "maximum number of vertices of a cage limits their level");
}
