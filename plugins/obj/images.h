#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "../common/host.h"
#include "../common/image.h"
#include "material_file.h"

namespace candela_plugins::obj {

/// The images of all materials, each once. They are requested first, then decoded on all threads of the host
/// and added, and then known by their indices. A file that is neither PNG nor JPEG is noted and left out.
class Images {
  public:
    explicit Images(const Host& host) : host_(host) {}

    /// A requested image; none where there is nothing to add.
    using Request = std::optional<std::size_t>;

    // The textures of these may be NULL.

    Request whole(const TextureInfo* texture);
    /// RGB of one image, and a channel of the other as alpha.
    Request colorAndMask(const TextureInfo* color, const TextureInfo* mask);
    /// Roughness in G and metallic in B.
    Request roughnessAndMetallic(const TextureInfo* roughness, const TextureInfo* metallic);

    /// Adds the requested images. Progress goes from `from` to `to`.
    void addRequested(double from, double to);

    /// The host's index after `addRequested`; -1 for none.
    std::int32_t indexOf(const Request& request) const { return request ? indices_[*request] : -1; }

  private:
    /// The file of a texture.
    struct File {
        Bytes bytes;
        std::string element;  ///< For failures.
    };

    std::optional<File> read(const TextureInfo* texture);
    template <typename MakeJob>
    Request request(const std::string& key, const MakeJob& makeJob);

    const Host& host_;
    std::map<std::string, std::size_t> requests_;  // By the sources of the image.
    std::set<std::string> ignoredFiles_;
    std::vector<ImageJob> jobs_;
    std::vector<std::int32_t> indices_;
};

}  // namespace candela_plugins::obj
