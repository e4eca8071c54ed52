#pragma once

#include <candela/export.h>
#include <candela/plugin_registry.h>
#include <candela/scene.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace candela {

/// What a note of an import tells, from the largest loss to none.
enum class NoteKind {
    missing,      ///< Something of the file is not in the picture, or in a simpler form.
    repaired,     ///< A value that the format forbids was replaced by one that it allows.
    information,  ///< Nothing is lost: such as which of several scenes is drawn.
};

/// What an import did with one or more elements of the file.
struct CANDELA_API ImportNote {
    NoteKind kind = NoteKind::missing;
    std::string text = {};  ///< One line of UTF-8, which names no element.
    /// "mesh 3 'wheel'", each once; none: the note is about the file.
    std::vector<std::string> elements = {};
    std::size_t count = 1;  ///< The number of elements, or how often the note was made where it has none.

    /// As programs print it: "mesh 3 'wheel' and 4 more: TEXT", or "TEXT (5 times)" without elements.
    std::string line() const;
};

/// The axis of a file that points up.
enum class UpAxis { y, z, x };

/// What a file says of its scene as a whole. The scene itself is in metres with +Y up: where the file is not,
/// its nodes, and its lights and cameras without a node, are below a node of index 0 that turns and scales
/// them.
struct SceneInfo {
    UpAxis upAxis = UpAxis::y;   ///< Of the file.
    double metresPerUnit = 1.0;  ///< Of the file, over 0.
    std::string generator = {};  ///< The program that wrote it; empty where that is not known.
    std::string copyright = {};  ///< To whom it belongs; empty where that is not known.
};

struct ImportReport {
    std::string plugin = {};  ///< Name of the plugin that read the scene.
    SceneInfo info = {};
    /// What is not in the picture before what was repaired before information, each kind with the largest
    /// counts first. Notes of the same kind and text are one. Of more than 1000 the last ones are only
    /// counted, in a note of their own.
    std::vector<ImportNote> notes = {};
};

struct ImportedScene {
    Scene scene = {};
    ImportReport report = {};
};

/// Called with the fraction done, 0 to 1, on the thread that called `importScene`. Returning false cancels
/// the import; an exception reaches the caller of `importScene`.
using ImportProgress = std::function<bool(double)>;

/// What becomes of a file of which parts are broken, or beyond what candela draws.
enum class Strictness {
    tolerant,  ///< The rest is drawn; each such part is a note.
    strict,    ///< A note of something missing or repaired is an error.
};

struct ImportOptions {
    Strictness strictness = Strictness::tolerant;
    ImportProgress progress = {};  ///< May be empty.
};

/// Reads a scene through the plugin that takes its scheme ("plaza:4096") or its file name ending
/// ("room.glb"). The scene has passed `validate`. Throws `Error`: badInput or unsupported with the file, the
/// element and the reason, badInput for an empty URI; environment when the file cannot be read; cancelled;
/// when strict, badInput with the first note that is not information.
CANDELA_API ImportedScene importScene(const PluginRegistry& plugins, const std::string& uri,
                                      const ImportOptions& options = {});

}  // namespace candela
