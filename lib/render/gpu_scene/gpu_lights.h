#pragma once

#include "render/gpu_scene/record_buffer.h"

#include <candela/gpu_scene.h>
#include <candela/light.h>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include <span>
#include <vector>

namespace candela {

class ThreadPool;

struct LightCounts {
    int points = 0, spots = 0, directionals = 0;
    int shadowed = 0;  ///< Of all of these: those that cast shadows.
};

/// Positions and ranges, a column each, for culling many at a time. The columns are `padding` longer than the
/// lights are many.
struct LightReaches {
    static constexpr std::size_t padding = 16;

    std::vector<float> x, y, z, range;

    std::size_t size() const { return x.empty() ? 0 : x.size() - padding; }
    void reserve(std::size_t size);
    void resize(std::size_t size);
    glm::vec3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Where lights without a range end.
struct RangeRule {
    Bounds region;         ///< Where surfaces may be, world space.
    double maxLoss = 0.0;  ///< As `rangeIrradiance` takes it.

    bool operator==(const RangeRule& other) const {
        return region.min == other.region.min && region.max == other.region.max && maxLoss == other.maxLoss;
    }
};

/// When lights are uploaded.
enum class LightUpload {
    atOnce,     ///< By `set` and `upload`.
    whenBound,  ///< By `records` and `cones`: on devices where frames may be lit from the copy in memory.
};

/// The lights as the shaders read them: points first, then spots, then directional lights.
class GpuLights {
  public:
    GpuLights(const glm::dmat3& workingFromRec709, LightUpload when);

    /// Replaces all lights, on all cores. Throws `Error`: badInput naming the first light whose numbers break
    /// what `WorldLight` states, limit when the device can not hold as many; nothing is changed then.
    void set(std::span<const WorldLight> lights, const RangeRule& rule);
    /// Moves and rotates one of the lights of the last `set`, whose other values do not change. A light whose
    /// new position is not finite, because a world matrix overflows, stays where it is.
    void move(std::uint32_t index, const WorldLight& light);
    /// Moves a light as `move` does, and replaces its intensity, range and cone angles. One that has a range
    /// keeps one.
    void change(std::uint32_t index, const WorldLight& light);
    /// Moves each light that has a radius to its point in the sample of this number; 0 is its centre. Holds
    /// for later moves too, until the next `set`, which is of sample 0.
    void setSample(std::uint32_t sample);
    std::uint32_t sample() const { return sample_; }
    /// Do samples move any light?
    bool hasSpheres() const { return !spheres_.empty(); }
    bool hasRangeless() const { return !rangeless_.empty(); }
    /// Has a light without a range moved since the last `assignRanges`?
    bool rangelessMoved() const { return rangelessMoved_; }
    /// Do the lights without a range have those of the rule?
    bool areAssigned(const RangeRule& rule) const { return !rangelessMoved_ && assigned_ == rule; }
    /// Gives the lights without a range the ranges of the rule.
    void assignRanges(const RangeRule& rule);
    /// Uploads the lights changed since the last call, or marks them for `records`. Returns how many those
    /// are.
    std::size_t upload();

    const LightCounts& counts() const { return counts_; }
    bool anyCastsShadow() const { return counts_.shadowed > 0; }
    /// Where the points and spots reach, in the order of the records.
    const LightReaches& reaches() const { return reaches_; }
    /// The records: LIGHT_TEXELS texels a light, and a cone of one texel a spot.
    std::span<const glm::vec4> recordData() const { return records_.texels(); }
    std::span<const glm::vec4> coneData() const { return cones_.texels(); }
    const LightReport& report() const { return report_; }

    /// On the device. Throws `Error` (limit) with `LightUpload::whenBound` where it has no memory for them.
    const gl::BufferTexture& records() const { return uploaded(records_); }
    const gl::BufferTexture& cones() const { return uploaded(cones_); }

  private:
    struct Chunk;

    static std::vector<Chunk> countLights(std::span<const WorldLight> lights, ThreadPool& pool);
    /// Replaces the numbers of each chunk by those of the chunks before it. Returns those of all.
    static Chunk sumUp(std::vector<Chunk>& chunks);
    const gl::BufferTexture& uploaded(RecordBuffer<glm::vec4>& buffer) const;
    void reserve(const Chunk& all);
    void resize(const Chunk& all);
    /// Writes the lights of a chunk to the records and lists from where `to` counts on.
    void write(std::span<const WorldLight> lights, Chunk to);
    void writeLocal(std::uint32_t record, const WorldLight& light);
    std::uint32_t recordOf(std::uint32_t index) const { return recordOf_.empty() ? index : recordOf_[index]; }
    void writePosition(std::uint32_t record, const glm::vec3& position);
    /// Writes the positions of `spheres_` in a sample.
    void placeSpheres(std::uint32_t sample);
    void writeDirectional(std::span<glm::vec4> record, const WorldLight& light) const;
    std::uint32_t coneOf(std::uint32_t record) const {
        return record - static_cast<std::uint32_t>(counts_.points);
    }
    void writeRange(std::uint32_t record, float range);
    float brightestChannel(std::uint32_t record) const;
    glm::vec4 intensityTexel(const WorldLight& light) const;

    glm::dmat3 workingFromRec709_;
    LightUpload when_;
    LightCounts counts_;
    LightReport report_;
    LightReaches reaches_;
    std::vector<std::uint32_t> recordOf_;   ///< Of each light; empty where records are in the same order.
    std::vector<std::uint32_t> rangeless_;  ///< Records of the lights without a range.
    std::vector<bool> isRangeless_;         ///< Of each point or spot record; empty where all have a range.
    bool rangelessMoved_ = false;
    RangeRule assigned_;  ///< Of the last `assignRanges`.
    /// A light with a radius.
    struct Sphere {
        std::uint32_t index;  ///< In the last `set`.
        glm::vec3 center;
        float radius;
    };
    std::vector<Sphere> spheres_;  ///< Sorted by index.
    std::uint32_t sample_ = 0;     ///< In which their positions are.
    /// With `LightUpload::whenBound` the device's copies are brought up to date when they are asked for.
    mutable RecordBuffer<glm::vec4> records_, cones_;
};

}  // namespace candela
