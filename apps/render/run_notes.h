#pragma once

#include "run_report.h"

#include <candela/exposure.h>
#include <candela/frame_data.h>
#include <candela/gpu_scene.h>

#include <cstdint>
#include <map>
#include <string>

/// What is wrong with the pictures of a run, told once for each kind.
class PictureNotes {
  public:
    void add(const candela::ExposureCounts& counts);
    void tell(RunReport& report) const;

  private:
    int pictures_ = 0;
    std::map<std::string, int> counts_;
};

/// What the layers of transparent surfaces leave out, told once for a run.
class LayerNotes {
  public:
    void add(const candela::LayerCounts& counts);
    /// `layers`: those of --layers.
    void tell(RunReport& report, std::uint32_t layers) const;

  private:
    int pictures_ = 0, incomplete_ = 0;
    std::uint64_t maxFragmentsBeyond_ = 0;
};

/// Tells what lights without a range are drawn with. `rangeLoss` is that of --range-loss.
void noteLights(RunReport& report, const candela::LightReport& lights, float rangeLoss);

/// Tells that subdivision cages are drawn as polygons, where no plugin refines them.
void noteMissingSubdivider(RunReport& report, const candela::CageReport& cages);

/// Tells how many cages are coarser than the options ask for.
void noteLodClamped(RunReport& report, const candela::CageReport& cages);
