#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace candela {

/// A number as errors show it.
std::string shortNumber(float value);

/// An element of a scene as errors name it: "mesh 3 'wheel'". Refers to the name it is given; costs nothing
/// until a rule is broken.
class ErrorContext {
  public:
    /// Without an index the label is "mesh 'wheel'".
    ErrorContext(const char* kind, std::optional<std::size_t> index, const std::string& name)
        : kind_(kind), index_(index), name_(name) {}

    /// Control characters of the name become '?', and a long name is cut: an error is one line.
    std::string label() const;

    /// Throws `Error` (badInput): "LABEL: REASON".
    [[noreturn]] void refuse(const std::string& reason) const;

    /// Refuses with the text of `rule` unless it holds.
    void require(bool holds, const char* rule) const {
        if (!holds) refuse(rule);
    }

    /// Refuses unless least <= value <= most, which a NaN never is.
    void requireWithin(const char* what, float value, float least, float most) const;

    /// Refuses an index beyond the `count` elements of `kind` that the scene has.
    void requireIndex(const char* kind, std::optional<std::uint32_t> index, std::size_t count) const;

  private:
    const char* kind_;
    std::optional<std::size_t> index_;
    const std::string& name_;
};

}  // namespace candela
