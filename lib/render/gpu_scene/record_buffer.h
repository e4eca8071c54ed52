#pragma once

#include "gl/texture.h"

#include <candela/error.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace candela {

/// Records of a fixed number of 16-byte texels that shaders read through a buffer texture, with a copy in
/// memory. An upload sends only what has changed since the last one.
template <typename Texel>
class RecordBuffer {
  public:
    RecordBuffer(GLenum format, std::size_t texelsPerRecord, const char* label)
        : format_(format), label_(label), texelsPerRecord_(texelsPerRecord), texture_(format, label) {}

    std::size_t size() const { return texels_.size() / texelsPerRecord_; }
    std::span<const Texel> texels() const { return texels_; }
    const gl::BufferTexture& texture() const { return texture_; }

    /// Makes room for as many records, without changing any. Throws `Error` (limit) when the device has none;
    /// nothing is changed then.
    void reserve(std::size_t records) {
        reserveMemory(records);
        reserveDevice(records);
    }
    /// As `reserve`, but `upload` makes the room on the device, and may throw `Error` (limit) then.
    void reserveMemory(std::size_t records) {
        gl::BufferTexture::requireTexels(records * texelsPerRecord_);
        texels_.reserve(records * texelsPerRecord_);
    }
    /// Sets the number of records, for which there is room; all are to be written.
    void resize(std::size_t records) {
        texels_.resize(records * texelsPerRecord_);
        allEdited_ = true;
    }
    /// Makes the records more than they are; the new ones are to be written. Makes more room than it needs,
    /// so that growing by one takes constant time on average. Throws `Error` (limit) beyond what the device's
    /// buffer textures hold; nothing is changed then.
    void grow(std::size_t records) {
        gl::BufferTexture::requireTexels(records * texelsPerRecord_);
        if (records * texelsPerRecord_ > texels_.capacity()) texels_.reserve(3 * texels_.size() / 2 + 16);
        const std::size_t first = size();
        texels_.resize(records * texelsPerRecord_);
        for (std::size_t i = first; i < records; ++i) edit(static_cast<std::uint32_t>(i));
        grows_ = true;
    }
    /// A record to be written; it is uploaded next time.
    std::span<Texel> edit(std::uint32_t record) {
        if (!allEdited_) edited_.push_back(record);
        // From here on one upload of all takes less than sorting what has changed.
        if (edited_.size() > size() / 2) allEdited_ = true;
        return recordOf(record);
    }
    /// A record after `resize`, before anything else. Different records may be written by different threads.
    std::span<Texel> fill(std::uint32_t record) { return recordOf(record); }

    /// Returns how many records were edited since the last call; all, where most were.
    std::size_t countEdited() {
        std::ranges::sort(edited_);
        const auto repeated = std::ranges::unique(edited_);
        edited_.erase(repeated.begin(), repeated.end());
        const std::size_t count = allEdited_ ? size() : edited_.size();
        allChanged_ = allChanged_ || allEdited_ || changed_.size() + edited_.size() > size() / 2;
        if (!allChanged_) changed_.insert(changed_.end(), edited_.begin(), edited_.end());
        edited_.clear();
        allEdited_ = false;
        return count;
    }
    /// Returns what `countEdited` would.
    std::size_t upload() {
        const std::size_t count = countEdited();
        if (grows_ && size() > capacity_) reserveMore();
        reserveDevice(size());
        if (allChanged_) {
            write(0, size());
        } else {
            writeChanged();
        }
        allChanged_ = false;
        changed_.clear();
        return count;
    }

  private:
    std::span<Texel> recordOf(std::uint32_t record) {
        return std::span(texels_).subspan(record * texelsPerRecord_, texelsPerRecord_);
    }
    void reserveDevice(std::size_t records) {
        if (records <= capacity_) return;
        gl::BufferTexture larger(format_, label_);
        larger.reserve(records * texelsPerRecord_ * sizeof(Texel));
        texture_ = std::move(larger);
        capacity_ = records;
        allChanged_ = true;
    }
    /// Half as much again as there is, where the device has room for that.
    void reserveMore() {
        try {
            reserveDevice(std::max(size(), capacity_ + capacity_ / 2));
        } catch (const Error&) {
            // What is needed has to do.
        }
    }
    /// Records between two changed ones are sent along where that takes less than another call.
    void writeChanged() {
        std::ranges::sort(changed_);
        constexpr std::uint32_t maxGap = 32;
        for (std::size_t first = 0; first < changed_.size();) {
            std::size_t last = first;
            while (last + 1 < changed_.size() && changed_[last + 1] - changed_[last] <= maxGap) ++last;
            write(changed_[first], changed_[last] - changed_[first] + 1);
            first = last + 1;
        }
    }
    void write(std::size_t first, std::size_t count) {
        if (count == 0) return;
        const std::span<const Texel> run =
            std::span<const Texel>(texels_).subspan(first * texelsPerRecord_, count * texelsPerRecord_);
        glNamedBufferSubData(texture_.buffer(),
                             static_cast<GLintptr>(first * texelsPerRecord_ * sizeof(Texel)),
                             static_cast<GLsizeiptr>(run.size_bytes()), run.data());
    }

    GLenum format_;
    const char* label_;
    std::size_t texelsPerRecord_;
    std::size_t capacity_ = 0;  ///< Records on the device.
    std::vector<Texel> texels_;
    std::vector<std::uint32_t> edited_;   ///< Since the last `countEdited`.
    std::vector<std::uint32_t> changed_;  ///< Until then, since the last upload.
    bool allEdited_ = false, allChanged_ = false;
    bool grows_ = false;
    gl::BufferTexture texture_;
};

}  // namespace candela
