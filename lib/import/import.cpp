#include <candela/import.h>

#include "import/abi_import.h"
#include "import/file_access.h"
#include "import/host.h"
#include "import/note_list.h"
#include "import/plugin_frames.h"
#include "import/plugin_options.h"
#include "import/scene_source.h"
#include "import/text.h"

#include <candela/error.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace candela {
namespace {

std::unique_ptr<FileAccess> filesOf(const SceneSource& source) {
    return source.folder.empty() ? nullptr : std::make_unique<FileAccess>(source.folder);
}

[[noreturn]] void failWithoutReason(const SceneSource& source, const std::string& uri, const char* how) {
    throw Error(ErrorKind::badInput, uri, joined("the plugin '", source.plugin->name, "' ", how));
}

std::vector<OptionValue> optionsOf(const SceneSource& source, const std::string& uri) {
    const candela_importer& importer = *source.plugin->importer;
    if (!source.query || importer.option_count == 0) return {};
    try {
        return parseOptions(checkedOptions(importer), *source.query);
    } catch (const Error& error) {
        throw Error(error.kind(), uri, error.what());
    }
}

// A plugin must not throw. An exception that can be caught becomes an error like others.
void callImporter(const SceneSource& source, const std::string& uri, const ImportHost& host) {
    candela_request request{};
    request.struct_size = sizeof request;
    request.uri = uri.c_str();
    request.name = source.name.c_str();
    request.query = source.query ? source.query->c_str() : nullptr;
    const std::vector<OptionValue> values = optionsOf(source, uri);
    std::vector<candela_option_value> options;
    for (const OptionValue& value : values)
        options.push_back({value.option, 0, value.number, value.text.c_str()});
    request.option_count = static_cast<std::uint32_t>(options.size());
    request.options = options.data();
    candela_status status = CANDELA_FAILED;
    try {
        status = source.plugin->importer->import_scene(&host.interface(), &request);
    } catch (...) {
        host.rethrowFailure();
        failWithoutReason(source, uri, "threw an exception, which the plugin interface forbids");
    }
    host.rethrowFailure();
    if (status != CANDELA_OK) failWithoutReason(source, uri, "failed and gave no reason");
}

/// What a frame callback may move, of meshes that have all attributes.
PluginFrameCallback::Elements takeMoved(ImportHost& host, Scene& scene) {
    PluginFrameCallback::Elements moved;
    for (const AddedMovedMesh& mesh : host.movedMeshes())
        moved.meshes.emplace_back(mesh, scene.meshes[mesh.mesh]);
    moved.cages = host.takeMovedCages();
    return moved;
}

void finish(const PluginRegistry& plugins, ImportHost& host, ImportedScene& imported, NoteList& notes,
            const std::string& uri) {
    Scene& scene = imported.scene;
    try {
        addMissingAttributes(scene, notes);
        PluginFrameCallback::Elements moved = takeMoved(host, scene);
        const std::size_t nodes = scene.nodes.size();
        bringToMetres(imported.report.info, scene);
        moved.firstNode = static_cast<std::uint32_t>(scene.nodes.size() - nodes);
        chooseOrigin(scene);
        if (std::unique_ptr<OwnedFrameCallback> callback = host.takeFrameCallback()) {
            scene.frameCallback = std::make_shared<PluginFrameCallback>(
                PluginFrameCallback::Source{plugins, imported.report.plugin, uri, host.takeFiles()},
                std::move(callback), std::move(moved), scene);
        }
        validate(scene);
    } catch (const Error& error) {
        if (!error.path().empty()) throw;
        throw Error(error.kind(), uri, error.what());
    }
}

}  // namespace

ImportedScene importScene(const PluginRegistry& plugins, const std::string& uri,
                          const ImportOptions& options) {
    const SceneSource source = findSource(plugins, uri);
    ImportHost host(uri, filesOf(source), options.progress, plugins.imageDecoders());
    callImporter(source, uri, host);
    NoteList notes = host.takeNotes();
    ImportedScene imported{host.takeScene(), {source.plugin->name, host.sceneInfo(), {}}};
    finish(plugins, host, imported, notes, uri);
    imported.report.notes = notes.take();
    if (options.strictness == Strictness::strict) refuseLosses(imported.report.notes, uri);
    return imported;
}

}  // namespace candela
