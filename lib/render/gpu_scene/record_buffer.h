#pragma once

#include "gl/texture.h"

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

    std::span<const Texel> texels() const { return texels_; }
    const gl::BufferTexture& texture() const { return texture_; }

    /// Makes room for as many records, without changing any. Throws `Error` (limit) when the device has none;
    /// nothing is changed then.
    void reserve(std::size_t records) {
        texels_.reserve(records * texelsPerRecord_);
        if (records <= capacity_) return;
        gl::BufferTexture larger(format_, label_);
        larger.upload(std::span<const Texel>(std::vector<Texel>(records * texelsPerRecord_)));
        texture_ = std::move(larger);
        capacity_ = records;
        allChanged_ = true;
    }
    /// Sets the number of records, for which there is room; all are to be written.
    void resize(std::size_t records) {
        texels_.resize(records * texelsPerRecord_);
        allChanged_ = true;
    }
    /// A record to be written; it is uploaded next time.
    std::span<Texel> edit(std::uint32_t record) {
        if (!allChanged_) changed_.push_back(record);
        // From here on one upload of all takes less than sorting what has changed.
        if (changed_.size() > texels_.size() / texelsPerRecord_ / 2) allChanged_ = true;
        return std::span(texels_).subspan(record * texelsPerRecord_, texelsPerRecord_);
    }

    /// Returns how many records have changed; all, where most have.
    std::size_t upload() {
        std::size_t count = 0;
        if (allChanged_) {
            count = texels_.size() / texelsPerRecord_;
            write(0, count);
        } else {
            std::ranges::sort(changed_);
            const auto repeated = std::ranges::unique(changed_);
            changed_.erase(repeated.begin(), repeated.end());
            count = changed_.size();
            writeChanged();
        }
        allChanged_ = false;
        changed_.clear();
        return count;
    }

  private:
    /// Records between two changed ones are sent along where that takes less than another call.
    void writeChanged() {
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
    std::size_t capacity_ = 0;  ///< Records.
    std::vector<Texel> texels_;
    std::vector<std::uint32_t> changed_;
    bool allChanged_ = false;
    gl::BufferTexture texture_;
};

}  // namespace candela
