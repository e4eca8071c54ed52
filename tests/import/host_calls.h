#pragma once

#include "import/host.h"

#include <candela/plugin.h>

// Adds to a host without a plugin between.

inline void add(const candela_host& host, const candela_mesh& mesh) {
    host.add_mesh(host.self, &mesh);
}
inline void add(const candela_host& host, const candela_node& node) {
    host.add_node(host.self, &node);
}
inline void add(const candela_host& host, const candela_cage& cage) {
    host.add_cage(host.self, &cage);
}
inline void add(const candela_host& host, const candela_skin& skin) {
    host.add_skin(host.self, &skin);
}
inline void add(const candela_host& host, const candela_animation& animation) {
    host.add_animation(host.self, &animation);
}
inline void add(const candela_host& host, const candela_cage_instance& instance) {
    host.add_cage_instance(host.self, &instance);
}

/// What comes of a scene that `addAll` adds. Throws what the host has refused.
template <class AddAll>
candela::Scene importedScene(AddAll addAll) {
    candela::ImportHost host("test", nullptr, {});
    addAll(host.interface());
    host.rethrowFailure();
    return host.takeScene();
}

/// `source` with one change.
template <class Source, class Spoil>
Source spoiled(Source source, Spoil spoil) {
    spoil(source);
    return source;
}
