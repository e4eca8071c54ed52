#include "layers.h"

#include "source_tree.h"

#include <algorithm>
#include <map>
#include <set>

namespace candela {

namespace {

namespace fs = std::filesystem;

using Names = std::set<std::string>;

// The layers whose headers each layer may include.
const std::map<std::string, Names> visibleTo = {
    {"abi", {"abi"}},
    {"base", {"abi", "base"}},
    {"scene", {"abi", "base", "scene"}},
    {"shading", {"abi", "base", "scene", "shading"}},
    {"import", {"abi", "base", "scene", "shading", "import"}},
    {"color", {"abi", "base", "scene", "shading", "color"}},
    {"gl", {"abi", "base", "gl"}},
    {"render", {"abi", "base", "scene", "shading", "import", "color", "gl", "render"}},
};

// The layer of each public header.
const std::map<std::string, std::string> layerOfHeader = {
    {"plugin.h", "abi"},
    {"error.h", "base"},
    {"export.h", "base"},
    {"image.h", "base"},
    {"image_file.h", "base"},
    {"image_stream.h", "base"},
    {"nearest_name.h", "base"},
    {"version.h", "base"},
    {"whole_file.h", "base"},
    {"animation.h", "scene"},
    {"brdf.h", "shading"},
    {"cage.h", "scene"},
    {"camera.h", "scene"},
    {"light.h", "scene"},
    {"default_lights.h", "scene"},
    {"exposure.h", "render"},
    {"material.h", "scene"},
    {"mesh.h", "scene"},
    {"node.h", "scene"},
    {"geometry.h", "scene"},
    {"shapes.h", "scene"},
    {"refined_cage.h", "scene"},
    {"scene.h", "scene"},
    {"deformation.h", "scene"},
    {"environment.h", "scene"},
    {"import.h", "import"},
    {"plugin_registry.h", "import"},
    {"subdivider.h", "import"},
    {"color.h", "color"},
    {"threads.h", "base"},
    {"context.h", "gl"},
    {"frame_data.h", "render"},
    {"frame_settings.h", "render"},
    {"gbuffer.h", "render"},
    {"panorama.h", "render"},
    {"pending.h", "render"},
    {"picture_parts.h", "render"},
    {"property_edits.h", "scene"},
    {"gpu_scene.h", "render"},
    {"handle.h", "render"},
    {"renderer.h", "render"},
    {"accumulator.h", "render"},
    {"sampling.h", "render"},
};

const std::string umbrella = "candela.h";

// Other libraries, by the prefix of their headers' names, and the layers of lib/ that may include them.
struct Library {
    const char* prefix;
    Names layers;
};

const std::vector<Library> libraries = {
    {"GL/", {"gl", "render"}},
    {"GLES", {"gl", "render"}},
    {"EGL/", {"gl", "render"}},
    {"KHR/", {"gl", "render"}},
    {"epoxy/", {"gl", "render"}},
    {"embree3/", {"render"}},
    {"GLFW/", {}},
    {"OpenColorIO/", {"color"}},
    {"OpenEXR/", {"base"}},
    {"Imath/", {"base"}},
    {"Imf", {"base"}},
    {"Iex", {"base"}},
    {"png.h", {"base"}},
    {"tiny_gltf", {}},
    {"nlohmann/", {}},
    {"opensubdiv/", {}},
    {"CLI/", {}},
    {"imgui", {}},
};

// The renderer on top of lib/render. Its passes, in the folders below, take what they need as values, and
// include none of it.
const std::vector<std::string> facade = {"candela/frame.h", "render/frame.h", "render/renderer_state.h"};

const std::vector<std::string> codeEndings = {".h", ".cpp", ".c", ".h.in"};

std::string firstFolder(const std::string& name) {
    return name.substr(0, name.find('/'));
}

bool isStandard(const std::string& name) {
    return name.find_first_of("./") == std::string::npos || name == "stddef.h" || name == "stdint.h";
}

bool isBelow(const fs::path& file, const fs::path& folder) {
    const fs::path relative = file.lexically_normal().lexically_relative(folder.lexically_normal());
    return !relative.empty() && *relative.begin() != "..";
}

class Check {
  public:
    explicit Check(fs::path root) : root_(std::move(root)) {}

    std::vector<std::string> violations() {
        for (const fs::path& file : filesBelow(root_ / "include/candela", codeEndings))
            checkPublicHeader(file);
        for (const fs::path& file : filesBelow(root_ / "lib", codeEndings)) checkLibraryFile(file);
        for (const fs::path& file : filesBelow(root_ / "plugins", codeEndings)) checkPluginFile(file);
        for (const fs::path& file : filesBelow(root_ / "plugins", {"CMakeLists.txt"})) checkPluginLinks(file);
        for (const fs::path& file : filesBelow(root_ / "apps", codeEndings)) checkAppFile(file);
        for (const fs::path& file : filesBelow(root_ / "python", codeEndings)) checkBindingFile(file);
        return violations_;
    }

  private:
    void report(const fs::path& file, std::size_t line, const std::string& reason) {
        violations_.push_back(file.lexically_relative(root_).generic_string() + ":" + std::to_string(line) +
                              ": " + reason);
    }

    // `layer` includes the public header `name`, without its folder.
    void checkPublicInclude(const fs::path& file, const Include& include, const std::string& layer) {
        const std::string name = include.name.substr(std::string("candela/").size());
        const auto found = layerOfHeader.find(name);
        if (found == layerOfHeader.end()) {
            report(file, include.line, "includes candela/" + name + ", which has no layer");
        } else if (!visibleTo.at(layer).contains(found->second)) {
            report(file, include.line, layer + " must not include candela/" + name + " of " + found->second);
        }
    }

    void checkPublicHeader(const fs::path& file) {
        std::string name = file.filename().string();
        if (name.ends_with(".in")) name.resize(name.size() - 3);
        if (name == umbrella) return;
        const auto layer = layerOfHeader.find(name);
        if (layer == layerOfHeader.end()) return report(file, 1, "a public header without a layer");
        for (const Include& include : includesOf(file)) {
            if (include.name.starts_with("candela/")) {
                checkPublicInclude(file, include, layer->second);
            } else if (!isStandard(include.name) && !include.name.starts_with("glm/")) {
                report(file, include.line, "a public header must not include " + include.name);
            } else if (layer->second == "abi" && include.name != "stddef.h" && include.name != "stdint.h") {
                report(file, include.line, "plugin.h is C, and must not include " + include.name);
            }
        }
    }

    void checkLibraryFile(const fs::path& file) {
        const std::string layer = firstFolder(file.lexically_relative(root_ / "lib").generic_string());
        if (!visibleTo.contains(layer) || layer == "abi") return report(file, 1, "a folder that is no layer");
        const bool isPass = layer == "render" && file.parent_path() != root_ / "lib/render";
        for (const Include& include : includesOf(file)) {
            const std::string folder = firstFolder(include.name);
            if (isPass && std::ranges::find(facade, include.name) != facade.end())
                report(file, include.line, "a pass must not include " + include.name);
            if (folder == "candela") {
                checkPublicInclude(file, include, layer);
            } else if (folder == "shared") {
                if (layer != "shading" && layer != "gl" && layer != "render")
                    report(file, include.line, layer + " must not include shaders");
            } else if (visibleTo.contains(folder)) {
                if (visibleTo.at(layer).contains(folder)) continue;
                report(file, include.line, layer + " must not include " + include.name);
            } else if (include.quoted) {
                report(file, include.line,
                       "a private header is included as \"LAYER/name.h\", not " + include.name);
            } else {
                checkLibrary(file, include, layer);
            }
        }
    }

    void checkLibrary(const fs::path& file, const Include& include, const std::string& layer) {
        for (const Library& library : libraries) {
            if (!include.name.starts_with(library.prefix) || library.layers.contains(layer)) continue;
            report(file, include.line, layer + " must not include " + include.name);
        }
    }

    void checkPluginFile(const fs::path& file) {
        const fs::path plugins = root_ / "plugins";
        const fs::path own = plugins / firstFolder(file.lexically_relative(plugins).generic_string());
        const fs::path common = plugins / "common";
        for (const Include& include : includesOf(file)) {
            if (include.name == "candela/plugin.h") continue;
            const fs::path beside = file.parent_path() / include.name;
            const bool isOwn = isFileBelow(beside, own) || isFileBelow(beside, common);
            if (isLibraryHeader(include) || (include.quoted && !isOwn)) {
                report(file, include.line, "a plugin must not include " + include.name);
            }
        }
    }

    void checkPluginLinks(const fs::path& file) {
        const std::vector<std::string> lines = readLines(file);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string code = lines[i].substr(0, lines[i].find('#'));
            for (const auto& [layer, visible] : visibleTo) {
                if (code.find("candela_" + layer) != std::string::npos) {
                    report(file, i + 1, "a plugin must not link candela_" + layer);
                }
            }
            if (code.find("candela::") == std::string::npos) continue;
            report(file, i + 1, "a plugin must not link candela");
        }
    }

    void checkAppFile(const fs::path& file) {
        const fs::path apps = root_ / "apps";
        const fs::path own = apps / firstFolder(file.lexically_relative(apps).generic_string());
        const fs::path common = apps / "common";
        for (const Include& include : includesOf(file)) {
            const fs::path beside = file.parent_path() / include.name;
            const bool isOwn = isFileBelow(beside, own) || isFileBelow(own / include.name, own) ||
                               isFileBelow(beside, common) || isFileBelow(apps / include.name, common);
            checkUserInclude(file, include, isOwn, "an app");
        }
    }

    void checkBindingFile(const fs::path& file) {
        for (const Include& include : includesOf(file)) {
            const bool isOwn = isFileBelow(file.parent_path() / include.name, file.parent_path());
            checkUserInclude(file, include, isOwn, "the Python package");
        }
    }

    // What `user`, who has the installed library, includes.
    void checkUserInclude(const fs::path& file, const Include& include, bool isOwn, const std::string& user) {
        if (include.name.starts_with("candela/")) {
            const std::string name = include.name.substr(std::string("candela/").size());
            if (layerOfHeader.contains(name) || name == umbrella) return;
            report(file, include.line, "there is no public header " + include.name);
        } else if (include.quoted ? !isOwn : isLibraryHeader(include)) {
            report(file, include.line, user + " must not include " + include.name);
        }
    }

    // Whether the included header belongs to the library of this tree.
    static bool isLibraryHeader(const Include& include) {
        const std::string folder = firstFolder(include.name);
        if (folder == include.name) return false;
        return folder == "candela" || folder == "shared" || folder == "lib" || visibleTo.contains(folder);
    }

    static bool isFileBelow(const fs::path& file, const fs::path& folder) {
        return isBelow(file, folder) && fs::is_regular_file(file);
    }

    fs::path root_;
    std::vector<std::string> violations_;
};

}  // namespace

std::vector<std::string> layerViolations(const fs::path& root) {
    return Check(root).violations();
}

std::vector<std::string> missingInUmbrella(const fs::path& root) {
    Names included;
    for (const Include& include : includesOf(root / "include/candela" / umbrella))
        included.insert(include.name);
    std::vector<std::string> missing;
    for (const auto& [name, layer] : layerOfHeader) {
        if (name != "export.h" && !included.contains("candela/" + name)) missing.push_back(name);
    }
    return missing;
}

}  // namespace candela
