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

/// KTX2 files of 8 × 4 texels in base64: (200, 40, 20, 255) on the left, (20, 60, 220, 128) on the right.
/// Made by basisu 1.16, of its codecs ETC1S and, with Zstandard, UASTC.
extern const char* const etc1sFile;
extern const char* const uastcFile;

/// A file with a material whose emission texture is image 0 in this URI, by the extension of its format.
GltfFile fileWithImage(const std::string& uri, const std::string& extension);

}  // namespace candela_test
