#pragma once

#include <candela/plugin.h>

#include <string>

#include "failure.h"

namespace candela_importers {

/// The host of an import, with exceptions in place of status values: whatever the host refuses throws
/// `HostRefused`, since the host has recorded the reason.
class Host {
  public:
    explicit Host(const candela_host& host) : host_(host) {}

    /// Valid until the import ends.
    Bytes readFile(const std::string& path) const;
    void note(const std::string& text) const;
    /// `fraction` of the whole import, 0 to 1.
    void progress(double fraction) const;

    /// Each returns the index the host gave the element.
    std::int32_t add(const candela_image& image) const;
    std::int32_t add(const candela_material& material) const;
    std::int32_t add(const candela_mesh& mesh) const;
    std::int32_t add(const candela_node& node) const;
    std::int32_t add(const candela_camera& camera) const;
    std::int32_t add(const candela_light& light) const;
    std::int32_t add(const candela_animation& animation) const;
    std::int32_t add(const candela_cage& cage) const;
    std::int32_t add(const candela_skin& skin) const;
    void show(const candela_cage_instance& shown) const;

    /// Whether the host knows cages, skins and polygons, which came with version 1.1. One that does not must
    /// not be given any.
    bool takesCages() const;

  private:
    const candela_host& host_;
};

/// The query of a request; NULL where there is none, and from a host older than queries.
const char* queryOf(const candela_request& request);

}  // namespace candela_importers
