#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "document.h"
#include "material_file.h"

namespace candela_plugins::obj {

/// The materials of the .mtl files of a document. A file that is missing is noted; where there is one of the
/// scene's own name, as "chair.mtl" for "chair.obj", it takes its place.
class MaterialLibrary {
  public:
    /// `sceneFile` is the name of the OBJ file.
    MaterialLibrary(const Document& document, const std::string& sceneFile, const Host& host);

    /// NULL where no file has it: that is noted, unless a file is missing which may have it.
    const FileMaterial* find(const std::string& name) const;

  private:
    /// A file that was not found, and why.
    struct Missing {
        std::string element, reason;
    };

    void readNamed(const std::string& name);
    std::optional<Missing> read(const std::string& name);
    void replaceMissing(const Document& document);
    void indexNames();

    const std::string sceneFile_;
    const Host& host_;
    std::vector<std::string> readPaths_;
    std::vector<Missing> missing_;
    bool isComplete_ = true;  ///< All files were read.
    std::vector<FileMaterial> materials_;
    std::unordered_map<std::string, const FileMaterial*> byName_, byLowerCaseName_;
};

}  // namespace candela_plugins::obj
