#pragma once

#include <cmath>
#include <cstdint>
#include <iterator>
#include <random>
#include <vector>

namespace candela {

/// Random values, often edge cases. The sequence is the same on every machine.
class FuzzInput {
  public:
    explicit FuzzInput(std::uint32_t seed) : engine_(seed) {}

    /// Less than `count`, which is 1 or more.
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(engine_()) % count; }
    bool once(std::uint32_t in) { return below(in) == 0; }

    float number() {
        constexpr float edgeCases[] = {0.0f,  -0.0f, 1.0f,    -1.0f,    0.5f,       1e-45f,   1e-20f,    1e9f,
                                       1e10f, 1e20f, 3.4e38f, -3.4e38f, 1.5707964f, INFINITY, -INFINITY, NAN};
        return edgeCases[below(std::size(edgeCases))];
    }

    std::uint32_t index() {
        constexpr std::uint32_t edgeCases[] = {0, 1, 2, 3, 4, 6, 9, 0x7fffffffu, 0xfffffffeu, 0xffffffffu};
        return edgeCases[below(std::size(edgeCases))];
    }

    template <typename Vector>
    void corrupt(Vector& vector) {
        vector[static_cast<int>(below(static_cast<std::uint32_t>(vector.length())))] = number();
    }

    /// An element of `values`, which is not empty.
    template <typename Value>
    Value& pick(std::vector<Value>& values) {
        return values[below(static_cast<std::uint32_t>(values.size()))];
    }

    /// Sets an element, where there is one.
    template <typename Value>
    void setOne(std::vector<Value>& values, Value value) {
        if (!values.empty()) pick(values) = value;
    }

  private:
    std::mt19937 engine_;
};

}  // namespace candela
