#pragma once

#include <cstdint>

namespace plaza {

/// Mixes all bits of a number: the finaliser of MurmurHash3 (Austin Appleby, public domain).
constexpr std::uint32_t mixBits(std::uint32_t bits) {
    bits ^= bits >> 16;
    bits *= 0x85EBCA6Bu;
    bits ^= bits >> 13;
    bits *= 0xC2B2AE35u;
    bits ^= bits >> 16;
    return bits;
}

/// A number of [0, 1) for the element `index` and one of its properties. It is a multiple of 2^-24, so that
/// float holds it exactly, and the same on every machine.
constexpr double hashedShare(std::uint32_t index, std::uint32_t property) {
    const std::uint32_t bits = mixBits(mixBits(index + 1u) + 0x9E3779B9u * (property + 1u));
    return static_cast<double>(bits >> 8) / 16777216.0;
}

}  // namespace plaza
