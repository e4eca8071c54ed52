#pragma once

#include "import/host.h"

#include <candela/plugin.h>

// Calls of a host's functions without a plugin.

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

/// The scene that `addAll` adds. Throws when the host refuses an element.
template <class AddAll>
candela::Scene importedScene(AddAll addAll) {
    candela::ImportHost host("test", nullptr, {});
    addAll(host.interface());
    host.rethrowFailure();
    return host.takeScene();
}

/// `source` with one change.
template <class Source, class Modify>
Source modified(Source source, Modify modify) {
    modify(source);
    return source;
}
