#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

struct PngPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;  ///< Rows from the top.

    /// The mean of R, G and B over all pixels, 0 to 255.
    double mean() const;
    /// The number of distinct colours.
    std::size_t colors() const;
    /// True when every pixel's alpha is 255.
    bool opaque() const;
};

struct ExrPicture {
    int width = 0, height = 0;
    std::map<std::string, std::vector<float>> channels;  ///< Rows from the top.
    bool floats = true;                                  ///< All channels are 32-bit float.
    bool chromaticities = false;                         ///< The file states its primaries.
    std::map<std::string, std::string> texts;            ///< Attributes of the header.

    std::vector<std::string> names() const;
    float at(const std::string& channel, int x, int y) const;
};

/// Both throw when the file is incomplete.
PngPicture readPng(const std::string& path);
ExrPicture readExr(const std::string& path);
