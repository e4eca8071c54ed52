#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace candela_plugins::gltf {

/// Numbers that lie in a buffer of the document, which outlives this, or in memory of their own. Large arrays
/// are not copied where the file has them as the host takes them.
template <typename Number>
class Numbers {
  public:
    Numbers() = default;
    explicit Numbers(std::vector<Number> own) : own_(std::move(own)) {}
    explicit Numbers(std::span<const Number> inBuffer) : inBuffer_(inBuffer) {}

    std::span<const Number> view() const {
        return inBuffer_.empty() ? std::span<const Number>(own_) : inBuffer_;
    }
    const Number* data() const { return view().data(); }
    std::size_t size() const { return view().size(); }
    bool empty() const { return view().empty(); }

    /// The numbers in memory of their own, to be changed.
    std::vector<Number>& edit() {
        if (!inBuffer_.empty()) own_.assign(inBuffer_.begin(), inBuffer_.end());
        inBuffer_ = {};
        return own_;
    }
    std::vector<Number> take() && { return std::move(edit()); }

    void append(Numbers&& more) {
        if (empty()) {
            *this = std::move(more);
            return;
        }
        edit().insert(own_.end(), more.view().begin(), more.view().end());
    }

  private:
    std::span<const Number> inBuffer_;
    std::vector<Number> own_;
};

}  // namespace candela_plugins::gltf
