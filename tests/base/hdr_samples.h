#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace candela {

/// Mantissas of red, green and blue, and the exponent + 128.
using Rgbe = std::array<std::uint8_t, 4>;

inline void writeBytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

/// What the texel stands for: mantissas are the middle of their step.
inline double valueOf(const Rgbe& texel, std::size_t channel) {
    return texel[3] == 0 ? 0.0 : std::ldexp(texel[channel] + 0.5, texel[3] - 136);
}

/// Texels of which none is 1, 1, 1 and whose runs are short and long.
inline std::vector<Rgbe> someTexels(std::uint32_t count) {
    std::vector<Rgbe> texels;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto step = static_cast<std::uint8_t>(i / 5);
        texels.push_back({static_cast<std::uint8_t>(128 + step), static_cast<std::uint8_t>(7 * i),
                          static_cast<std::uint8_t>(i < count / 2 ? 200 : 3 * step),
                          static_cast<std::uint8_t>(120 + i % 3)});
    }
    return texels;
}

inline std::string radianceHeader(const std::string& size, const std::string& variables = "") {
    return "#?RADIANCE\n# by a test\n" + variables + "FORMAT=32-bit_rle_rgbe\n\n" + size + "\n";
}

inline std::string uncoded(const std::vector<Rgbe>& texels) {
    std::string bytes;
    for (const Rgbe& texel : texels) bytes.append(texel.begin(), texel.end());
    return bytes;
}

/// Runs of whole texels: 1, 1, 1, N.
inline std::string oldRuns(const std::vector<Rgbe>& texels, std::uint32_t width) {
    std::string bytes;
    for (std::size_t line = 0; line < texels.size(); line += width) {
        for (std::size_t i = line; i < line + width;) {
            bytes.append(texels[i].begin(), texels[i].end());
            std::size_t run = 1;
            while (i + run < line + width && texels[i + run] == texels[i]) ++run;
            i += run;
            // Further runs in a row are higher digits.
            for (std::size_t rest = run - 1; rest > 0; rest >>= 8)
                bytes += std::string("\1\1\1", 3) + static_cast<char>(rest & 255);
        }
    }
    return bytes;
}

/// Runs of each channel by itself.
inline std::string newRuns(const std::vector<Rgbe>& texels, std::uint32_t width) {
    std::string bytes;
    for (std::size_t line = 0; line < texels.size(); line += width) {
        bytes += {2, 2, static_cast<char>(width >> 8), static_cast<char>(width & 255)};
        for (std::size_t channel = 0; channel < 4; ++channel) {
            const auto at = [&](std::size_t i) { return static_cast<char>(texels[line + i][channel]); };
            for (std::size_t i = 0; i < width;) {
                std::size_t run = 1;
                while (i + run < width && run < 127 && at(i + run) == at(i)) ++run;
                if (run > 2) {
                    bytes += {static_cast<char>(128 + run), at(i)};
                    i += run;
                } else {
                    const std::size_t count = std::min<std::size_t>(width - i, 3);
                    bytes += static_cast<char>(count);
                    for (std::size_t k = 0; k < count; ++k) bytes += at(i + k);
                    i += count;
                }
            }
        }
    }
    return bytes;
}

}  // namespace candela
