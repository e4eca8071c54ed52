#include "host.h"

#include <cstddef>

namespace candela_plugins {
namespace {

std::int32_t accepted(std::int32_t index) {
    if (index < 0) throw HostRefused{};
    return index;
}

}  // namespace

Bytes Host::readFile(const std::string& path) const {
    candela_bytes bytes{};
    if (host_.read_file(host_.self, path.c_str(), &bytes) != CANDELA_OK) throw HostRefused{};
    return {bytes.data, bytes.size};
}

Bytes Host::readOptionalFile(const std::string& path, const std::string& element) const {
    const bool offered =
        host_.struct_size >= offsetof(candela_host, read_optional_file) + sizeof host_.read_optional_file;
    if (!offered) return readFile(path);
    candela_bytes bytes{};
    const char* reason = "";
    if (host_.read_optional_file(host_.self, path.c_str(), &bytes, &reason) == CANDELA_OK)
        return {bytes.data, bytes.size};
    if (!*reason) throw HostRefused{};
    throw Failure{element, reason};
}

void Host::noteLeftOut(const Failure& failure) const {
    note(CANDELA_NOTE_MISSING, failure.element, failure.reason + ": left out");
}

void Host::note(candela_note_kind kind, const std::string& element, const std::string& text) const {
    if (host_.struct_size >= offsetof(candela_host, add_note) + sizeof host_.add_note) {
        host_.add_note(host_.self, kind, element.c_str(), text.c_str());
        return;
    }
    host_.note(host_.self, (element.empty() ? text : element + ": " + text).c_str());
}

void Host::progress(double fraction) const {
    if (host_.progress(host_.self, fraction) != CANDELA_OK) throw HostRefused{};
}

std::int32_t Host::add(const candela_image& image) const {
    return accepted(host_.add_image(host_.self, &image));
}

std::int32_t Host::add(const candela_material& material) const {
    return accepted(host_.add_material(host_.self, &material));
}

std::int32_t Host::add(const candela_mesh& mesh) const {
    return accepted(host_.add_mesh(host_.self, &mesh));
}

std::int32_t Host::add(const candela_node& node) const {
    return accepted(host_.add_node(host_.self, &node));
}

std::int32_t Host::add(const candela_camera& camera) const {
    return accepted(host_.add_camera(host_.self, &camera));
}

std::int32_t Host::add(const candela_light& light) const {
    return accepted(host_.add_light(host_.self, &light));
}

std::int32_t Host::add(const candela_animation& animation) const {
    return accepted(host_.add_animation(host_.self, &animation));
}

std::int32_t Host::add(const candela_cage& cage) const {
    return accepted(host_.add_cage(host_.self, &cage));
}

std::int32_t Host::add(const candela_skin& skin) const {
    return accepted(host_.add_skin(host_.self, &skin));
}

void Host::add(const candela_cage_instance& instance) const {
    if (host_.add_cage_instance(host_.self, &instance) != CANDELA_OK) throw HostRefused{};
}

void Host::add(const candela_deformation& deformation) const {
    if (host_.add_deformation(host_.self, &deformation) != CANDELA_OK) throw HostRefused{};
}

void Host::set(const candela_environment& environment) const {
    if (host_.set_environment(host_.self, &environment) != CANDELA_OK) throw HostRefused{};
}

void Host::addVariant(const std::string& name) const {
    accepted(host_.add_variant(host_.self, name.c_str()));
}

bool Host::takesVariants() const {
    return host_.struct_size >= offsetof(candela_host, add_variant) + sizeof host_.add_variant;
}

bool Host::takesEnvironments() const {
    return host_.struct_size >= offsetof(candela_host, set_environment) + sizeof host_.set_environment;
}

bool Host::takesDeformations() const {
    return host_.struct_size >= offsetof(candela_host, add_deformation) + sizeof host_.add_deformation;
}

bool Host::takesCages() const {
    return host_.struct_size >= offsetof(candela_host, add_cage_instance) + sizeof host_.add_cage_instance;
}

const char* queryOf(const candela_request& request) {
    const bool hasQuery = request.struct_size >= offsetof(candela_request, query) + sizeof request.query;
    return hasQuery ? request.query : nullptr;
}

}  // namespace candela_plugins
