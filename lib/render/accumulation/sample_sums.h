#pragma once

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/gbuffer/gbuffer_targets.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// An RGBA32F picture to draw into.
struct SampleTarget {
    SampleTarget(int width, int height, const char* label);
    gl::Texture texture;
    gl::Framebuffer framebuffer;
};

/// A sum of frames, in two levels: frames are added to the first, and each 256 of them to the second. No
/// addend meets more than 255 + 256 roundings of 2^-24 each. Radiance that a technique has left in memory is
/// summed there, on all cores; all else on the device.
class SampleSums {
  public:
    SampleSums(int width, int height);

    void clear();
    /// Adds what the targets hold.
    void add(const GBufferTargets& targets);
    /// Adds what a technique has in memory; the sums are not on the device (`isInMemory`). Uses no OpenGL.
    void addInMemory(const GBufferTargets::Memory& frame);
    bool isInMemory() const { return !onDevice_; }
    /// The first level of the sum in memory, RGBA, to which a host adds the radiance of a frame itself, and
    /// then calls `countInMemory` with its depth. Frames have been added in memory before.
    std::span<float> sumInMemory() { return memory_.sum; }
    void countInMemory(std::span<const float> depth);
    std::uint32_t count() const { return count_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// The mean of the frames added, of which there is one or more: RGBA32F, coverage in A.
    const gl::Texture& mean();
    /// The same where the sums are in memory, without OpenGL.
    std::span<const float> meanInMemory();

  private:
    /// The sums on the device, and what draws into them.
    struct Device {
        Device(int width, int height);
        SampleTarget sum, largeSum;
        gl::Program addProgram, meanProgram;
        gl::VertexArray vertexArray;
    };
    /// The sums in memory, RGBA without meaning in A, rows from the bottom; `largeSum` is empty before it is
    /// needed. Coverage is a whole number of frames, exact in single precision.
    struct Memory {
        std::vector<float> sum, largeSum, coverage, mean;
        std::uint32_t meanOf = 0;  ///< The count of which `mean` is.
    };

    void addOnDevice(const GBufferTargets& targets);
    /// Brings the sums in memory to the device, where they stay until the next `clear`.
    void moveToDevice();
    void carryInMemory();
    void draw(const gl::Program& program, const SampleTarget& into) const;
    /// Writes the sum of both levels over `divisor`.
    void writeMeanOnDevice(float divisor, const SampleTarget& into) const;

    int width_, height_;
    std::uint32_t count_ = 0;
    std::uint32_t meanOf_ = 0;  ///< The count of which `mean_` is.
    SampleTarget mean_;
    Memory memory_;
    bool onDevice_ = false;
    std::optional<Device> device_;  ///< Created by the first frame that is summed there.
};

}  // namespace candela
