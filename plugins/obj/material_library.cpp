#include "material_library.h"

#include <algorithm>

#include "references.h"
#include "statement.h"

namespace candela_plugins::obj {
namespace {

std::string elementOf(const std::string& name) {
    return "material file " + inQuotes(name);
}

/// "chair.mtl" for "chair.obj".
std::string ownNameOf(const std::string& sceneFile) {
    return sceneFile.substr(0, sceneFile.rfind('.')) + ".mtl";
}

}  // namespace

MaterialLibrary::MaterialLibrary(const Document& document, const std::string& sceneFile, const Host& host)
    : sceneFile_(sceneFile), host_(host) {
    for (std::size_t i = 0; i < document.materialFiles.size(); ++i) readNamed(document.materialFiles[i]);
    replaceMissing(document);
    indexNames();
}

void MaterialLibrary::readNamed(const std::string& name) {
    const std::optional<Missing> whole = read(name);
    if (!whole) return;
    // A name with blanks may be several names.
    std::vector<Missing> parts;
    const std::vector<std::string_view> words = wordsOf(name);
    for (const std::string_view word : words) {
        if (const auto part = read(std::string(word))) parts.push_back(*part);
    }
    if (parts.size() == words.size()) parts = {*whole};
    missing_.insert(missing_.end(), parts.begin(), parts.end());
}

std::optional<MaterialLibrary::Missing> MaterialLibrary::read(const std::string& name) {
    const std::string element = elementOf(name);
    const ReferencedFile file = findReferenced("", name, element, host_);
    if (!file.bytes) return Missing{element, file.reason};
    if (std::find(readPaths_.begin(), readPaths_.end(), file.path) != readPaths_.end()) return std::nullopt;
    readPaths_.push_back(file.path);
    if (isUtf16(textOf(*file.bytes))) {
        isComplete_ = false;
        host_.noteLeftOut({element, "UTF-16 text, expected UTF-8"});
    } else {
        parseMaterialFile(*file.bytes, file.path, host_, materials_);
    }
    return std::nullopt;
}

void MaterialLibrary::replaceMissing(const Document& document) {
    const bool namesNone = document.materialFiles.size() == 0 && document.materials.size() > 0;
    if (missing_.empty() && !namesNone) return;
    const std::string ownName = ownNameOf(sceneFile_);
    const bool isRead = !read(ownName);
    if (isRead && namesNone)
        host_.note(CANDELA_NOTE_INFORMATION, elementOf(ownName), "read, though no mtllib names it");
    for (const Missing& missing : missing_) {
        if (isRead)
            host_.note(CANDELA_NOTE_REPAIRED, missing.element,
                       missing.reason + ": " + inQuotes(ownName) + " is read in its place");
        else
            host_.note(CANDELA_NOTE_MISSING, missing.element,
                       missing.reason + ": its materials are drawn as the default one");
    }
    isComplete_ = isComplete_ && (isRead || missing_.empty());
}

void MaterialLibrary::indexNames() {
    for (const FileMaterial& material : materials_) {
        if (!byName_.try_emplace(material.name, &material).second)
            host_.note(CANDELA_NOTE_REPAIRED, material.element, "defined before: left out");
        byLowerCaseName_.try_emplace(lowerCase(material.name), &material);
    }
}

const FileMaterial* MaterialLibrary::find(const std::string& name) const {
    if (const auto found = byName_.find(name); found != byName_.end()) return found->second;
    const std::string element = "material " + inQuotes(name);
    if (const auto found = byLowerCaseName_.find(lowerCase(name)); found != byLowerCaseName_.end()) {
        host_.note(CANDELA_NOTE_INFORMATION, element,
                   "its name in the material file differs in upper and lower case");
        return found->second;
    }
    if (isComplete_)
        host_.note(CANDELA_NOTE_MISSING, element, "in no material file: the default one is drawn");
    return nullptr;
}

}  // namespace candela_plugins::obj
