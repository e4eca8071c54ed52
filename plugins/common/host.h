#pragma once

#include <candela/plugin.h>

#include <string>

#include "failure.h"
#include "parallel.h"

namespace candela_plugins {

/// The host of an import, with exceptions instead of status values: an element that the host refuses throws
/// `HostRefused`.
class Host {
  public:
    explicit Host(const candela_host& host) : host_(host) {}

    /// Valid until the import ends.
    Bytes readFile(const std::string& path) const;
    /// The same, for a file without which the import goes on: throws `Failure` for `element` when it cannot
    /// be read. An older host fails the import.
    Bytes readOptionalFile(const std::string& path, const std::string& element) const;
    /// `element` names the part that the note is about, such as "mesh 3 'wheel'"; empty: the whole file. The
    /// host merges notes of the same kind and text, so `text` holds nothing that differs between elements.
    void note(candela_note_kind kind, const std::string& element, const std::string& text) const;
    /// Notes that the part at fault is missing from the picture.
    void noteLeftOut(const Failure& failure) const;
    /// Calls `action`, which reads a part of the scene. A `Failure` becomes a note that this part is left
    /// out. Returns whether there was one.
    template <typename Action>
    bool leavesOut(const Action& action) const {
        try {
            action();
            return false;
        } catch (const Failure& failure) {
            noteLeftOut(failure);
            return true;
        }
    }
    /// `fraction` of the whole import, 0 to 1.
    void progress(double fraction) const;

    /// Each returns the index that the host gave the element; instances have none.
    std::int32_t add(const candela_image& image) const;
    std::int32_t add(const candela_material& material) const;
    std::int32_t add(const candela_mesh& mesh) const;
    std::int32_t add(const candela_node& node) const;
    std::int32_t add(const candela_camera& camera) const;
    std::int32_t add(const candela_light& light) const;
    std::int32_t add(const candela_animation& animation) const;
    std::int32_t add(const candela_cage& cage) const;
    std::int32_t add(const candela_skin& skin) const;
    void add(const candela_cage_instance& instance) const;
    void add(const candela_deformation& deformation) const;
    void set(const candela_environment& environment) const;
    void addVariant(const std::string& name) const;

    /// Whether the host has cages, skins and polygons, which came with version 1.1.
    bool takesCages() const;
    /// Whether the host has what deforms meshes, which came with version 1.3.
    bool takesDeformations() const;
    /// Whether the host has environments, which came with version 1.5.
    bool takesEnvironments() const;
    /// Whether the host has variants, which came with version 1.6.
    bool takesVariants() const;
    /// Whether materials may have a strength of emission, which came with version 1.6.
    bool takesEmissionStrength() const { return takesVariants(); }
    /// Whether meshes may be lines and points, which came with version 1.6.
    bool takesLinesAndPoints() const { return takesVariants(); }
    /// Whether meshes may have more than two sets of texture coordinates, which came with version 1.6.
    bool takesFurtherUvs() const { return takesVariants(); }

    /// Calls `body(index)` for each index below `count` on the threads of the host, see `parallel.h`.
    template <typename Body>
    void parallelFor(std::size_t count, const Body& body) const {
        candela_plugins::parallelFor(host_, static_cast<std::uint32_t>(count),
                                     [&](std::uint32_t index, std::uint32_t) { body(index); });
    }

  private:
    const candela_host& host_;
};

/// The query of a request; NULL where there is none, and from a host older than queries.
const char* queryOf(const candela_request& request);

}  // namespace candela_plugins
