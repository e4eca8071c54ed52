#pragma once

#include <candela/export.h>

#include <stdexcept>
#include <string>

namespace candela {

/// What kind of thing went wrong. An expected miss is a `std::optional`, never an `Error`.
enum class ErrorKind {
    badInput,     ///< A file, a scene or an argument is not what it has to be.
    unsupported,  ///< The input is well-formed, but asks for something candela does not do.
    environment,  ///< The machine lacks something: a file, a device, disk space, an OpenGL version.
    limit,        ///< A size is beyond what the device or the file format can hold.
    cancelled,    ///< The caller's own progress callback asked to stop.
};

/// An argument or input that is not what it has to be, or a lacking environment; thrown in every build type.
/// `what()` is one line: "PATH: TEXT", or just the text when no file is at fault.
class CANDELA_API Error : public std::runtime_error {
  public:
    /// `path` is the file or URI at fault, empty when there is none. `text` names the element and what was
    /// expected.
    Error(ErrorKind kind, std::string path, const std::string& text);

    ErrorKind kind() const { return kind_; }
    const std::string& path() const { return path_; }

  private:
    ErrorKind kind_;
    std::string path_;
};

}  // namespace candela
