#pragma once

#include "import/host.h"

#include <candela/plugin.h>

// Pushes to a host without a plugin between.

inline void push(const candela_host& host, const candela_mesh& mesh) {
    host.add_mesh(host.self, &mesh);
}
inline void push(const candela_host& host, const candela_node& node) {
    host.add_node(host.self, &node);
}
inline void push(const candela_host& host, const candela_cage& cage) {
    host.add_cage(host.self, &cage);
}
inline void push(const candela_host& host, const candela_skin& skin) {
    host.add_skin(host.self, &skin);
}
inline void push(const candela_host& host, const candela_animation& animation) {
    host.add_animation(host.self, &animation);
}
inline void push(const candela_host& host, const candela_cage_instance& shown) {
    host.show_cage(host.self, &shown);
}

/// What comes of a scene that `pushAll` pushes. Throws what the host has refused.
template <class PushAll>
candela::Scene pushedScene(PushAll pushAll) {
    candela::ImportHost host("test", nullptr, {});
    pushAll(host.interface());
    host.rethrowFailure();
    return host.takeScene();
}

/// `pushed` with one change.
template <class Pushed, class Spoil>
Pushed spoiled(Pushed pushed, Spoil spoil) {
    spoil(pushed);
    return pushed;
}
