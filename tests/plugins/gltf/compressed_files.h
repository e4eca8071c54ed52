#pragma once

#include <string>
#include <vector>

#include "gltf_file.h"

namespace candela_test {

/// A bent grid of side × side vertices.
struct Grid {
    std::vector<float> positions, normals;
    std::vector<std::uint32_t> indices;
};

Grid makeGrid(std::uint32_t side);

// Streams of EXT_meshopt_compression: `count` elements of `stride` bytes, triangles and other indices.
Bytes compressAttributes(const void* elements, std::size_t count, std::size_t stride);
Bytes compressTriangles(const std::vector<std::uint32_t>& indices, std::size_t vertices);
Bytes compressIndices(const std::vector<std::uint32_t>& indices, std::size_t vertices);

/// A file whose buffer views are compressed: buffer 0 holds the streams, and buffer 1 is not in the file.
class CompressedFile {
  public:
    explicit CompressedFile(std::string extension = "EXT_meshopt_compression")
        : extension_(std::move(extension)) {}

    /// `more` are further members of the extension, such as "\"mode\":\"INDICES\"".
    int addView(const Bytes& compressed, std::size_t count, std::size_t stride, const std::string& more);
    /// The file with its buffers.
    GltfFile finish();

    GltfFile file;

  private:
    std::string extension_;
    Bytes binary_;
};

/// The grid as a Draco stream: attribute 0 is the position, of 14 bits, and 1 the normal, of 10 bits. `speed`
/// is 0 (smallest) to 10, which is a sequential stream.
Bytes compressGrid(const Grid& grid, int speed);
/// A file of one mesh from such a stream, whose accessors state these counts.
GltfFile dracoFile(const Bytes& stream, std::size_t vertices, std::size_t indices);

/// A lossless WebP file of RGBA texels.
Bytes makeWebp(const std::vector<std::uint8_t>& rgba, int width, int height);

}  // namespace candela_test
