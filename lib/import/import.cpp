#include <candela/import.h>

#include "import/abi_import.h"
#include "import/file_access.h"
#include "import/host.h"
#include "import/note_list.h"
#include "import/scene_source.h"
#include "import/text.h"

#include <candela/error.h>

#include <memory>
#include <string>

namespace candela {
namespace {

std::unique_ptr<FileAccess> filesOf(const SceneSource& source) {
    return source.folder.empty() ? nullptr : std::make_unique<FileAccess>(source.folder);
}

[[noreturn]] void failWithoutReason(const SceneSource& source, const std::string& uri, const char* how) {
    throw Error(ErrorKind::badInput, uri, joined("the plugin '", source.plugin->name, "' ", how));
}

// A plugin must not throw. An exception that can be caught becomes an error like others.
void callImporter(const SceneSource& source, const std::string& uri, const ImportHost& host) {
    candela_request request{};
    request.struct_size = sizeof request;
    request.uri = uri.c_str();
    request.name = source.name.c_str();
    request.query = source.query ? source.query->c_str() : nullptr;
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

void finish(Scene& scene, NoteList& notes, const std::string& uri) {
    try {
        addMissingAttributes(scene, notes);
        chooseOrigin(scene);
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
    ImportHost host(uri, filesOf(source), options.progress);
    callImporter(source, uri, host);
    NoteList notes = host.takeNotes();
    ImportedScene imported{host.takeScene(), {source.plugin->name, {}}};
    finish(imported.scene, notes, uri);
    imported.report.notes = notes.take();
    if (options.strictness == Strictness::strict) refuseLosses(imported.report.notes, uri);
    return imported;
}

}  // namespace candela
