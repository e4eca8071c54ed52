#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "../common/host.h"
#include "../common/image.h"
#include "material_file.h"

namespace candela_plugins::obj {

/// The images of all materials, each once. They are requested first, then decoded on all threads of the host
/// and added, and then known by their indices. A file that cannot be read or decoded is noted and left out.
class Images {
  public:
    explicit Images(const Host& host) : host_(host) {}

    /// A requested image; none where there is nothing to add.
    using Request = std::optional<std::size_t>;

    // The textures of these may be NULL.

    Request whole(const TextureInfo* texture);
    /// An image of normals that a bump map is in many files; one of heights is noted and left out.
    Request bump(const TextureInfo* texture);
    /// RGB of one image, and a channel of the other as alpha.
    Request colorAndMask(const TextureInfo* color, const TextureInfo* mask);
    /// Roughness in G and metallic in B.
    Request roughnessAndMetallic(const TextureInfo* roughness, const TextureInfo* metallic);

    /// Adds the requested images. Progress goes from `from` to `to`.
    void addRequested(double from, double to);

    /// The host's index after `addRequested`; -1 for none.
    std::int32_t indexOf(const Request& request) const { return request ? indices_[*request] : -1; }

    /// Whether a mask makes a part of the image transparent, after `addRequested`.
    bool hasHoles(const Request& request) const { return request && outcomes_[*request]->hasHoles; }

    /// `texture` after `addRequested`, or NULL where its file was left out.
    const TextureInfo* usable(const std::optional<TextureInfo>& texture) const;

  private:
    /// The file of a texture.
    struct File {
        Bytes bytes;
        std::string path;
        std::string element;  ///< For failures.
    };
    using Files = std::array<std::optional<File>, 2>;
    using Decoded = std::array<std::optional<Image>, 2>;
    /// Why a file of a job cannot be used.
    struct Fault {
        std::string path;
        Failure failure;
    };
    /// What a job has found, on a thread of its own.
    struct Outcome {
        std::vector<Fault> faults;
        bool hasHoles = false;
    };

    std::optional<File> read(const TextureInfo* texture);
    std::optional<File> find(const TextureInfo& texture);
    /// Requests an image that `make` combines of those of the files that can be decoded, one or more.
    Request request(const std::string& key, const Files& files,
                    std::function<Image(Decoded&, Outcome&)> make);

    const Host& host_;
    std::map<std::string, std::optional<File>> files_;  // By owner and name.
    std::map<std::string, std::size_t> requests_;       // By the sources of the image.
    std::vector<std::shared_ptr<Outcome>> outcomes_;    // Of each job.
    std::set<std::string> unusablePaths_;
    std::vector<ImageJob> jobs_;
    std::vector<std::int32_t> indices_;
};

}  // namespace candela_plugins::obj
