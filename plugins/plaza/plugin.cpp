#include <candela/plugin.h>

#include <algorithm>
#include <array>
#include <string>

#include "scenes.h"

namespace candela_plugins::plaza {
namespace {

/// A further procedural scene is a generator and a row of the table.
struct ProceduralScene {
    const char* scheme;
    void (*generate)(const Host& host, const std::string& arguments);
};

constexpr std::array proceduralScenes{
    ProceduralScene{"plaza", makePlaza},        ProceduralScene{"cloud", makeCloud},
    ProceduralScene{"rooms", makeRooms},        ProceduralScene{"sculpture", makeSculpture},
    ProceduralScene{"crowd", makeCrowd},        ProceduralScene{"colonnade", makeColonnade},
    ProceduralScene{"triangles", makeTriangles}};

constexpr auto schemes = [] {
    std::array<const char*, proceduralScenes.size() + 1> names{};
    for (std::size_t i = 0; i < proceduralScenes.size(); ++i) names[i] = proceduralScenes[i].scheme;
    return names;
}();

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string schemeOf(const std::string& uri) {
    std::string scheme = uri.substr(0, uri.find(':'));
    std::transform(scheme.begin(), scheme.end(), scheme.begin(), lower);
    return scheme;
}

void generate(const Host& host, const candela_request& request) {
    const std::string scheme = schemeOf(request.uri);
    for (const ProceduralScene& scene : proceduralScenes)
        if (scheme == scene.scheme) return scene.generate(host, request.name);
    throw Failure{"scheme", "'" + scheme + "' is not one of this plugin's"};
}

candela_status importScene(const candela_host* host, const candela_request* request) {
    return runGuarded(*host, [&] { generate(Host(*host), *request); });
}

constexpr candela_importer importer{
    sizeof(candela_importer), nullptr, schemes.data(), importScene, 0, nullptr};

constexpr candela_plugin plugin{
    sizeof(candela_plugin),
    CANDELA_PLUGIN_MAJOR,
    CANDELA_PLUGIN_MINOR,
    "plaza",
    "0.1.0",
    "procedural scenes under N point lights: plaza:N a square with 256 spheres, "
    "cloud:N a sphere of small lights, rooms:N 256 rooms, sculpture:N a subdivided ring, "
    "colonnade:N columns, crowd:N N walking characters, triangles:N,L N triangles and L lights",
    &importer,
    nullptr,
    nullptr};

}  // namespace
}  // namespace candela_plugins::plaza

const candela_plugin* candela_plugin_query(uint32_t hostMajor, uint32_t) {
    return hostMajor == CANDELA_PLUGIN_MAJOR ? &candela_plugins::plaza::plugin : nullptr;
}
